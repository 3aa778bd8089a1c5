// One tethered robot in a prepared world: many queries, one preparation.
#ifndef TAUTLINE_PLANNERS_TETHER_TETHER_PLANNER_H_
#define TAUTLINE_PLANNERS_TETHER_TETHER_PLANNER_H_

#include <memory>
#include <optional>

#include "tautline/base/error.h"
#include "tautline/homotopy/classes.h"
#include "tautline/homotopy/taut_space.h"
#include "tautline/planners/tether/plan.h"
#include "tautline/planners/tether/socket.h"

namespace tautline {

/// A tether length may be exceeded by this share of itself: rounding of sums must not forbid a tether that fits
/// exactly.
inline constexpr double kTetherTolerance = 1e-9;

/// The laid cable in the prepared space: where it starts, how it runs, where the robot stands.
struct LaidCable {
  /// Where it enters the free space.
  Socket socket;
  Walk walk;               ///< From the socket's exit to the robot.
  bool in_socket = false;  ///< The robot stands at the base, inside the socket.

  /// Where the robot stands, or, in the socket, where it comes out.
  Place robot() const { return {walk.at, walk.sleeve.back()}; }

  /// The start of any tether that can take this one's place: it leaves the exit by the sector that this one left by.
  Walk Root() const {
    Walk root(Place{walk.from, walk.sleeve.front()});
    root.rooted = !walk.is_free_to_turn();
    return root;
  }
};

/// Why a cable cannot lie as it is said to; `at` is the place.
struct LaidCableFault {
  /// What is wrong.
  PlanObstruction obstruction = PlanObstruction::kNone;
  /// Where, metres.
  Point at;
};

/// Immutable after preparation; queries may run in several threads.
class TetherPlanner {
 public:
  /// Builds free space and graph. Errors: as BuildFreeSpace. The costly part of planning.
  [[nodiscard]] static Expected<TetherPlanner> Prepare(const World& world);

  /// The shortest motion of the robot to the goal that the tether allows; see Plan in plan.h.
  PlanResult Plan(const Tether& tether, Point goal, const PlanOptions& options = {}) const;

  /// The cable as it lies, followed through the free space, or what is wrong with it.
  tl::expected<LaidCable, LaidCableFault> FollowLaidCable(const Tether& tether) const;

  /// A walk's taut curve from the base on: the stub of the socket, then the walk pulled taut.
  TautPath TetherAlong(const Socket& socket, const Walk& walk) const;

  /// Every class in which a tether can lie from the socket to the goal, shortest first; see FindClasses. `root` stands
  /// at the socket's exit. Lengths and limits include the stub.
  ClassList TethersTo(const Socket& socket, const Walk& root, Place goal, const ClassOptions& options) const;

  /// The free space with clearance, prepared for taut curves.
  const TautSpace& space() const { return *space_; }
  /// The free mesh without clearance: what a socket's stub may cross.
  const FreeMesh& ungrown() const { return ungrown_ ? *ungrown_ : space_->mesh(); }

 private:
  TetherPlanner() = default;

  void Choose(const LaidCable& laid, Place goal, const PlanOptions& options, PlanResult& result) const;
  void ListAll(const LaidCable& laid, Place goal, const PlanOptions& options, PlanResult& result) const;
  Motion MotionAlong(const LaidCable& laid, const Polyline& path) const;

  std::unique_ptr<const TautSpace> space_;
  std::unique_ptr<const FreeMesh> ungrown_;  ///< Only where there is a clearance.
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_TETHER_PLANNER_H_
