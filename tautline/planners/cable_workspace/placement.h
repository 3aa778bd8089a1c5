// What a placement of winches is worth: the best that cables can do from there.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_PLACEMENT_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_PLACEMENT_H_

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tautline/base/error.h"
#include "tautline/planners/cable_workspace/boundary.h"
#include "tautline/planners/cable_workspace/futures.h"
#include "tautline/planners/cable_workspace/outline_walk.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// What makes one placement better than another.
enum class PlaceObjective {
  kArea,   ///< The workspace is larger: its area, or with futures its expected area.
  kCable,  ///< Less cable is needed: the sum of the anchors' greatest lengths, with futures over all of them.
};

/// What is asked of a placement.
struct PlacementOptions {
  std::size_t anchors = 4;                           ///< How many winches: 3 or more.
  PlaceObjective objective = PlaceObjective::kArea;  ///< kCable needs tasks.
  std::optional<double> max_boundary = {};           ///< Metres; default: DefaultMaxBoundary.
  std::vector<Point> tasks = {};     ///< Places that the workspace must hold, inside or on its boundary.
  std::vector<Future> futures = {};  ///< As in a scene; empty: nothing moves.
  std::int64_t budget = 20'000;      ///< Of the search for boundaries, as in BestOptions.
};

/// How good a placement is. Less outside is better, since it leads a search to where all tasks are held; there the
/// better value counts.
struct PlacementWorth {
  double outside = 0;  ///< The sum of the distances of tasks from the workspace, metres; 0 where all are held.
  double value = 0;    ///< By the objective, square metres or metres of cable; the area where not all tasks are held.

  /// Whether all tasks are held.
  bool holds_all() const { return outside == 0; }
  /// Whether both are equal to the bit.
  friend bool operator==(const PlacementWorth&, const PlacementWorth&) = default;
};

/// A placement and the best boundary there.
struct Placement {
  std::vector<double> positions;  ///< Along the outline, ascending, metres.
  Anchors anchors;                ///< The winches.
  WorkspaceBoundary boundary;     ///< The best by the objective.
  PlacementWorth worth;           ///< What it is worth.
};

/// What a winch designer wants to know of a placement besides.
struct PlacementDetails {
  std::size_t tasks_held = 0;             ///< How many tasks the boundary holds.
  std::vector<double> longest_cables;     ///< By anchor, metres; over now and all futures.
  std::optional<FutureOutcomes> futures;  ///< What becomes of the boundary; where there are futures.
};

/// What came of one evaluation.
struct PlacementAnswer {
  std::optional<Placement> placement;  ///< Nothing where no winch can stand, or where there is no valid boundary.
  bool complete = true;                ///< No boundary was missed because the budget ran out.
};

/// A world in which winches are placed: everything that evaluations share. Immutable; evaluations may run in several
/// threads.
class PlacementGround {
 public:
  /// Errors: those of CableGround::Prepare; fewer than 3 anchors; the objective kCable without tasks; a limit that is
  /// not positive; a future that is not one of this world. Requires a world with an outline.
  [[nodiscard]] static Expected<PlacementGround> Prepare(const World& world, const PlacementOptions& options,
                                                         const Watcher& watch = {});

  /// The best boundary for winches at these positions, which are wrapped and sorted first. `to_beat`: where nothing
  /// better than this is there, the answer may be worse than the best, and comes sooner. Cost: that of FindBoundaries;
  /// with futures that of Futures::Prepare, too.
  PlacementAnswer Evaluate(std::vector<double> positions, const std::optional<PlacementWorth>& to_beat = {}) const;

  /// The cables of a placement that Evaluate returned, and its futures.
  PlacementDetails DetailsOf(const Placement& placement) const;

  /// Whether a worth is better than another.
  bool IsBetter(const PlacementWorth& a, const PlacementWorth& b) const;

  /// A task that no workspace can hold, since it lies on blocked ground or is cut off from the others.
  std::optional<std::size_t> lost_task() const { return lost_task_; }

  /// The ground.
  const CableGround& ground() const { return ground_; }
  /// What winches stand on: the boundary around the free ground, without clearance, that holds the tasks, or else the
  /// largest; counter-clockwise from its leftmost corner, of several the lowest.
  const OutlineWalk& outline() const { return outline_; }
  /// What was asked, with the default filled in.
  const PlacementOptions& options() const { return options_; }
  /// The greatest length of a boundary, metres.
  double max_boundary() const { return *options_.max_boundary; }

 private:
  PlacementGround(CableGround ground, OutlineWalk outline, const World& world, PlacementOptions options);

  using Boundaries = std::vector<WorkspaceBoundary>;

  std::optional<std::size_t> FindLostTask() const;
  double LimitToBeat(const std::optional<PlacementWorth>& to_beat) const;
  double Outside(const WorkspaceBoundary& boundary) const;
  Boundaries TakeHolding(Boundaries& boundaries) const;
  std::optional<Placement> Largest(Placement at, Boundaries boundaries) const;
  std::optional<Placement> LargestExpected(Placement at, Boundaries boundaries, const Futures& futures) const;
  std::optional<Placement> LeastCable(Placement at, Boundaries boundaries, const Futures* futures) const;
  std::optional<Placement> Nearest(Placement at, Boundaries boundaries) const;

  CableGround ground_;
  OutlineWalk outline_;
  World world_;
  PlacementOptions options_;
  std::optional<std::size_t> lost_task_;
};

/// The length that a boundary may have when nothing else is said: a quarter more than that of the outline, since it
/// winds around obstacles, and with a clearance four times it for each anchor, since each side has a stub at both ends.
/// The time to find all boundaries grows quickly with the limit.
double DefaultMaxBoundary(const OutlineWalk& outline, std::size_t anchors, double clearance);

/// How far a task is from a workspace, metres; 0 where it is inside or on the boundary, up to the ground's tolerance.
/// O(n) for n corners.
double DistanceToTask(const CableGround& ground, const WorkspaceBoundary& boundary, Point task);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_PLACEMENT_H_
