// Where a tether lets its robot go.
#ifndef TAUTLINE_PLANNERS_TETHER_REACH_H_
#define TAUTLINE_PLANNERS_TETHER_REACH_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tautline/base/error.h"
#include "tautline/homotopy/classes.h"
#include "tautline/planners/tether/plan.h"
#include "tautline/planners/tether/reach_sheets.h"
#include "tautline/planners/tether/region_ring.h"
#include "tautline/planners/tether/tether_planner.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// What is asked.
struct ReachOptions {
  bool sheets = false;             ///< Also class by class.
  std::int64_t budget = 100'000;   ///< Taut walks, for `sheets`, after which the count stops with kBudgetExceeded.
  std::optional<Point> at;         ///< A point to ask about.
  std::int64_t max_classes = 100;  ///< With `sheets`, list at most so many classes of that point.
  /// With `sheets`, told of the share of the budget that is used: an upper bound of what is left. At a no the count
  /// stops as at the budget's end.
  Watcher watch = {};
};

/// What the tether can do at one point.
struct ReachPoint {
  /// The point itself, metres.
  Point point;
  /// kNone where the robot can go; else kGoalBlocked, kGoalUnreachable or kTetherTooShort.
  PlanObstruction obstruction = PlanObstruction::kNone;
  std::string explanation;               ///< One sentence, unless it can go there.
  std::optional<TautPath> least_tether;  ///< The shortest tether to the point, whatever the limit.
  std::optional<ClassList> classes;      ///< With ReachOptions::sheets: those within the limit, shortest first.
};

/// The answer: the region, and what was asked besides.
struct ReachResult {
  /// How the search ended.
  PlanStatus status = PlanStatus::kInfeasible;
  PlanObstruction obstruction = PlanObstruction::kNone;  ///< kStartBlocked, or kTetherTooShort to leave a socket.
  std::string explanation;                               ///< One sentence with the numbers, unless solved.
  double limit = 0;                                      ///< The tether's length, metres.
  std::optional<Socket> socket;                          ///< Where the tether comes into the free space.
  double area = 0;                                       ///< Of the region, square metres.
  double connected_area = 0;                             ///< What an endless tether would reach, square metres.
  std::vector<RegionRing> regions;                       ///< The boundary of the region, the region on its left.
  /// The shortest tether to the middle of the longest arc, where it is fully out; nothing where there is no arc.
  std::optional<TautPath> stretched;
  std::optional<SheetList> sheets;  ///< With ReachOptions::sheets.
  std::optional<ReachPoint> at;     ///< With ReachOptions::at, unless infeasible.
};

/// The region of all points to which the robot can drive: those whose shortest tether is no longer than the limit. The
/// laid cable does not matter: it can be taken back along itself, and never needs more tether on the way [Yang2022].
/// Cost: one Dijkstra over the corners, and what they see within the tether. Sheets: exponential in the length, see
/// ReachSheets.
ReachResult Reach(const TetherPlanner& planner, const Tether& tether, const ReachOptions& options = {});

/// The same for a scene. Errors: the scene has no tether, or the world has no free space.
[[nodiscard]] Expected<ReachResult> Reach(const Scene& scene, const ReachOptions& options = {});

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_REACH_H_
