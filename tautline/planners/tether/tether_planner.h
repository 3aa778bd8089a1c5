// One tethered robot in a prepared world: many queries, one preparation.
#ifndef TAUTLINE_PLANNERS_TETHER_TETHER_PLANNER_H_
#define TAUTLINE_PLANNERS_TETHER_TETHER_PLANNER_H_

#include <memory>
#include <optional>

#include "tautline/base/error.h"
#include "tautline/homotopy/classes.h"
#include "tautline/homotopy/socket.h"
#include "tautline/homotopy/taut_ground.h"
#include "tautline/planners/tether/plan.h"

namespace tautline {

/// The laid cable in the prepared space: where it starts, how it runs, where the robot stands.
struct LaidCable {
  /// Where it enters the free space.
  Socket socket;
  Walk walk;               ///< From the socket's exit to the robot.
  bool in_socket = false;  ///< The robot stands at the base, inside the socket.

  /// Where the robot stands, or, in the socket, where it comes out.
  Place robot() const { return {walk.at, walk.sleeve.back()}; }

  /// The robot stands where the tether begins, and the cable has not been anywhere.
  bool at_root() const { return walk.sleeve.size() == 1 && walk.at == walk.from; }

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

/// A tether as it lies, prepared by TetherPlanner::PrepareStart for many goals. Immutable; valid as long as the
/// planner.
class PreparedStart {
 public:
  /// The tether as it was given.
  const Tether& tether() const { return tether_; }
  /// The laid cable, or what is wrong with it.
  const tl::expected<LaidCable, LaidCableFault>& laid() const { return laid_; }

 private:
  friend class TetherPlanner;
  friend class ShortestWays;

  PreparedStart(const Tether& tether, tl::expected<LaidCable, LaidCableFault> laid)
      : tether_(tether), laid_(std::move(laid)) {}

  Tether tether_;
  tl::expected<LaidCable, LaidCableFault> laid_;
  TautPath taut_;  ///< The laid cable pulled taut, base first; empty when it is blocked.
  /// The distances from the base and from the robot to everywhere. Nothing where one of them stands on a vertex at
  /// which blocked ground touches: there the way out matters, and each goal is searched for on its own.
  std::optional<GoalField> from_base_, from_robot_;
};

/// A goal prepared by TetherPlanner::PrepareGoal for many starts. Immutable; valid as long as the planner.
class PreparedGoal {
 public:
  /// The goal as it was given.
  Point point() const { return point_; }

 private:
  friend class TetherPlanner;

  PreparedGoal(Point point, std::optional<Place> place) : point_(point), place_(place) {}

  Point point_;
  std::optional<Place> place_;      ///< Nothing when the goal is blocked.
  std::optional<GoalField> field_;  ///< The distances to it from everywhere.
};

/// How a world is prepared.
struct PrepareOptions {
  Watcher watch = {};  ///< Told what is being prepared and how much of it is done; may stop it.
};

/// Plans in one world for many tethers and goals. Immutable after preparation; queries may run in several threads.
/// Requires tethers that CheckTether accepts and goals that CheckGoal accepts: anything else throws std::logic_error,
/// as broken invariants do.
class TetherPlanner {
 public:
  /// Builds free space and graph: the costly part of planning. Errors: as BuildFreeSpace; kStopped when `watch` said
  /// stop. O(n log n) for n boundary vertices and the size of all corners' sight; about 20 us per vertex of a map.
  [[nodiscard]] static Expected<TetherPlanner> Prepare(const World& world, const PrepareOptions& options = {});

  /// The shortest motion of the robot to the goal that the tether allows; see Plan in plan.h. Looks at the part of the
  /// visibility graph that lies between base, robot and goal.
  PlanResult Plan(const Tether& tether, Point goal, const PlanOptions& options = {}) const;

  /// The same for a tether that was prepared: for many goals. Only a goal whose shortest way the tether forbids needs a
  /// search; for the others it takes O(degree) per corner of the path.
  PlanResult Plan(const PreparedStart& start, Point goal, const PlanOptions& options = {}) const;

  /// The same for a goal that was prepared: for many tethers, as when a robot follows its plan.
  PlanResult Plan(const Tether& tether, const PreparedGoal& goal, const PlanOptions& options = {}) const;

  /// Follows the laid cable and finds the distances from both of its ends to everywhere. O(e log e) for e edges.
  PreparedStart PrepareStart(const Tether& tether) const;

  /// Finds the distances from everywhere to the goal. O(e log e) for e edges of the visibility graph.
  PreparedGoal PrepareGoal(Point goal) const;

  /// The cable as it lies, followed through the free space, or what is wrong with it.
  tl::expected<LaidCable, LaidCableFault> FollowLaidCable(const Tether& tether) const;

  /// A walk's taut curve from the base on: the stub of the socket, then the walk pulled taut.
  TautPath TetherAlong(const Socket& socket, const Walk& walk) const;

  /// Every class in which a tether can lie from the socket to the goal, shortest first; see FindClasses. `root` stands
  /// at the socket's exit. Lengths and limits include the stub.
  ClassList TethersTo(const Socket& socket, const Walk& root, Place goal, const ClassOptions& options) const;

  /// The free space with clearance, prepared for taut curves.
  const TautSpace& space() const { return ground_.space(); }
  /// The free space without clearance; that of `space` where there is none.
  const FreeSpace& ungrown_space() const { return ground_.ungrown_space(); }
  /// The free mesh without clearance: what a socket's stub may cross.
  const FreeMesh& ungrown() const { return ground_.ungrown(); }

 private:
  friend class PreparedFile;
  friend class CrossingFreeSearch;

  explicit TetherPlanner(TautGround ground) : ground_(std::move(ground)) {}

  PreparedStart StartOf(const Tether& tether) const;
  PreparedGoal GoalAt(Point goal) const;
  PlanResult Decide(const PreparedStart& start, const PreparedGoal& goal, const PlanOptions& options) const;
  void Decide(const PreparedStart& start, const PreparedGoal& goal, const PlanOptions& options,
              PlanResult& result) const;
  void Choose(const LaidCable& laid, const Polyline& direct, const GoalDistances& field, const PlanOptions& options,
              PlanResult& result) const;
  void ListAll(const LaidCable& laid, Place goal, const PlanOptions& options, PlanResult& result) const;
  Motion MotionAlong(const LaidCable& laid, const Polyline& path) const;

  TautGround ground_;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_TETHER_PLANNER_H_
