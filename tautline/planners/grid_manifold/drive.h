// A tethered robot that visits goals in order, with a simulated slack cable [Igarashi2010].
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_DRIVE_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_DRIVE_H_

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tautline/planners/grid_manifold/deadlocks.h"
#include "tautline/planners/grid_manifold/robot_driver.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// What decides where the robot drives.
enum class DriveController {
  kBasic,     ///< The field of the goal; the cable may be driven over. [Sec. 3.4]
  kExtended,  ///< Keeps off the cable, and untangles. [Secs. 4.1, 4.3]
  kRetract,   ///< A reel keeps the cable taut; back towards the base until the way is open. [Sec. 4.2]
};

/// How a way is found when the cable blocks all.
enum class Untangling {
  kHeuristic,  ///< The paper's.
  kSearch,     ///< A search tree.
  kBoth,       ///< The search where the heuristic fails.
};

/// How goals are visited.
struct DriveOptions {
  DriveController controller = DriveController::kExtended;  ///< What decides.
  RobotOptions robot;                                       ///< How the robot drives.
  double link_m = 0.05;                                     ///< Between nodes of the cable.
  VertexMask deadlocks = {};                                ///< Vertices not to be entered while there is another way.
  Untangling untangle = Untangling::kBoth;                  ///< Of the extended controller.
  int max_targets = 12;                                     ///< Of the heuristic, for a goal.
  int search_trials = 500;                                  ///< Of the search, for a goal.
  bool keep_retreat = false;                                ///< Refuses motions after which there is no way back.
  bool lookahead = true;                                    ///< Refuses visits after which later goals have no way.
  int lookahead_trials = 1000;                              ///< Motions to simulate for that, for a goal.
  std::function<void(std::size_t done)> on_goal = {};       ///< Told after every goal.
};

/// Why a goal was not visited.
enum class DriveFailure {
  kNone,            ///< It was.
  kGoalBlocked,     ///< It lies in a blocked cell or outside of the map.
  kTetherTooShort,  ///< No vertex of it can be reached, whatever the cable does.
  kWayNotFound,     ///< The cable blocks the way, and the heuristic or the budget came to its end.
  kNoWay,           ///< The cable blocks the way, and the search tried everything up to its resolution.
  kTimeUp,          ///< The time limit.
  kNotTried,        ///< A goal before it failed.
};

/// What became of a goal.
struct GoalOutcome {
  Point goal;                                  ///< Metres.
  DriveFailure failure = DriveFailure::kNone;  ///< Why it was not visited.
  double time_s = 0;                           ///< When it was visited, from the start.
  std::size_t steps = 0;                       ///< Vertices of the way until then.
  int targets = 0;                             ///< Intermediate targets on the way to it; for kRetract: drives back.
  int trials = 0;                              ///< Motions that were simulated to find them.
  bool searched = false;                       ///< The search found them.
  bool retreat_kept = true;                    ///< With keep_retreat: there is a way back afterwards.
  bool thought_again = false;      ///< Lookahead chose this visit because of a later goal, or so was it visited.
  bool deadlocks_entered = false;  ///< No way was found that keeps out of deadlocks.
};

/// What came of a drive.
struct DriveResult {
  DriveState end;                  ///< Where it ended, with all contacts and the whole way.
  std::vector<GoalOutcome> goals;  ///< As many as goals.

  /// Whether all goals were visited.
  bool Succeeded() const;
  /// How often the robot began to drive over its cable.
  std::size_t RobotContacts() const;
};

/// Why a drive cannot begin.
struct StartRefusal {
  std::string reason;       ///< "start_blocked", "tether_too_short", "laid_cable_blocked" or "laid_cable_too_long".
  std::string explanation;  ///< With the numbers, for a person.
};

/// What is left of a tether's length from the middle of the base's cell on, metres: what a manifold for drives is built
/// for, so that the cable suffices for all of its vertices. 0 where the base has no cell.
double LengthFromCell(const CellGround& ground, const Tether& tether);

/// Lays a tether's cable, and drives the robot to the middle of its cell. The manifold is one of LengthFromCell over
/// the ground of `space`. Requires a tether without fault. O(cable).
[[nodiscard]] tl::expected<DriveState, StartRefusal> StartDrive(const GridManifold& manifold, const TautSpace& space,
                                                                const Tether& tether, const DriveOptions& options);

/// The vertices that deadlocks close, for DriveOptions::deadlocks. O(vertices).
VertexMask ClosedBy(const GridManifold& manifold, const DeadlockAreas& areas);

/// Visits the goals in order, until one fails. Each motion is tried on a copy of the cable before it is driven, by the
/// same simulation, so the drive is what was tried. Deterministic. Throws Stopped when the robot's keep_going says no.
/// O(vertices) for each goal, and what is simulated.
DriveResult Drive(const GridManifold& manifold, const DriveState& start, std::span<const Point> goals,
                  const DriveOptions& options);

/// Drives a way again from where it began and tells of every step of the simulation: the same as the first time, to
/// the bit. Returns where it ends.
DriveState Replay(const GridManifold& manifold, const DriveState& start, std::span<const ManifoldVertex> way,
                  const RobotOptions& options, const RobotDriver::OnTick& on_tick = {});

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_DRIVE_H_
