// A disc on a cable that drives from cell to cell of a manifold.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_ROBOT_DRIVER_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_ROBOT_DRIVER_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "tautline/base/stop.h"
#include "tautline/cable/cable.h"
#include "tautline/planners/grid_manifold/find_way.h"
#include "tautline/planners/grid_manifold/manifold_goal_field.h"

namespace tautline {

/// Where a robot is, and how it came there. A copy drives on independently.
struct DriveState {
  Cable cable;                      ///< Its end is at the middle of the cell of `at`.
  ManifoldVertex at;                ///< Where the robot stands.
  std::vector<ManifoldVertex> way;  ///< All vertices that it drove to, in order.
};

/// How a leg of a drive ended.
enum class LegEnd {
  kThere,    ///< At the destination.
  kStopped,  ///< The caller's check said so.
  kBlocked,  ///< There is no open way any more, or new ones again and again.
  kTouched,  ///< The robot pulled its cable under itself.
  kTimeUp,   ///< The time limit has come.
};

/// How a robot drives.
struct RobotOptions {
  double speed_mps = 0.3;      ///< Always this. Positive.
  double dt_s = 0.05;          ///< Between steps of the simulation. Positive.
  double radius_m = 0.17;      ///< Of the disc.
  double time_limit_s = 3600;  ///< Simulated; the drive ends at the first vertex after it.
  KeepGoing keep_going = {};   ///< Asked now and then; at a no, drives throw Stopped.
};

/// Drives states of one robot. Not for several threads at once. Deterministic.
class RobotDriver {
 public:
  /// Asked at every vertex that a leg comes to; a yes ends the leg there.
  using ArrivalCheck = std::function<bool(const DriveState&)>;
  /// Told of every step of the simulation.
  using OnTick = std::function<void(const Cable&)>;

  /// The manifold must outlive it. `closed`: vertices not to be entered.
  RobotDriver(const GridManifold& manifold, const RobotOptions& options, VertexMask closed);

  /// The manifold.
  const GridManifold& manifold() const { return manifold_; }
  /// How it drives.
  const RobotOptions& options() const { return options_; }

  /// How often trials look whether the way is open: each time that the robot has driven as far as it is wide, seconds.
  double LookAfter() const { return 2 * options_.radius_m / options_.speed_mps; }

  /// The side of the squares by which states are told apart (StateKey): the robot's width, but no less than a cell's.
  double coarse_m() const { return std::max(2 * options_.radius_m, manifold_.ground().cell_m()); }

  /// That as a length of steps.
  LatticeDistance coarse() const { return LimitOf(coarse_m() / manifold_.ground().cell_m()); }

  /// How many legs ended at the time limit.
  std::int64_t time_ups() const { return time_ups_; }

  /// Other vertices not to be entered.
  void Close(VertexMask closed);

  /// What is open for a state; valid until the next call for any state. O(cells about the cable).
  OpenGround Look(const DriveState& state);

  /// Drives straight to the middle of a neighbour's cell. Where the cable forbids it, back, and the vertex is closed
  /// from then on: whether it does depends on vertices only.
  void StepTo(ManifoldVertex to, DriveState& state, const OnTick& on_tick = {});

  /// Keeps off the cable: drives a shortest open way, and looks for another one when the cable comes into it. Where a
  /// pull brings the cable under the robot, the leg ends. [Igarashi2010, Sec. 4.1]
  LegEnd Drive(const Destination& destination, DriveState& state, const ArrivalCheck& check = {});

  /// Follows a field, cable or not. [Igarashi2010, Sec. 3.4]
  LegEnd Follow(const ManifoldGoalField& field, const Destination& destination, DriveState& state);

  /// Drives back towards the base along the manifold until the check says yes or the base is reached: kStopped or
  /// kBlocked. [Igarashi2010, Sec. 4.2]
  LegEnd DriveBack(DriveState& state, const ArrivalCheck& check);

 private:
  bool IsTimeUp(const DriveState& state);
  bool Advance(Point to, Cable& cable, const OnTick& on_tick);

  const GridManifold& manifold_;
  RobotOptions options_;
  VertexMask closed_;  ///< With those that the cable forbade.
  VertexMask held_;    ///< Those alone.
  CableClearance clearance_;
  StopCheck stop_;
  std::int64_t time_ups_ = 0;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_ROBOT_DRIVER_H_
