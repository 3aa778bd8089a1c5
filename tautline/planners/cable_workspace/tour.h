// The shortest tour of the robot over unordered tasks inside its workspace [Wang2018, Sec. VI].
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_TOUR_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_TOUR_H_

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tautline/base/rng.h"
#include "tautline/base/stop.h"
#include "tautline/planners/cable_workspace/region_path.h"

namespace tautline {

/// Where the robot has to go.
struct TourStops {
  Point start;                ///< Where the robot is.
  std::vector<Point> tasks;   ///< To visit in any order; places may repeat.
  std::optional<Point> goal;  ///< Where it ends; absent: back at the start.
};

/// How hard to search.
struct TourOptions {
  std::size_t most_exact = 15;         ///< Up to so many tasks the tour is the shortest; at most kMostExactTasks.
  std::int64_t rounds_per_task = 500;  ///< Beyond: perturbations of the local search, for each task.
  Watcher watch = {};                  ///< Told the share that is done. At a no the search ends with what it has.
};

/// A tour.
struct Tour {
  std::vector<std::size_t> order;  ///< All tasks, by position from 0, as they are visited.
  std::vector<TautPath> legs;      ///< From the start to the first task, from task to task, and to the end.
  TautPath path;                   ///< All legs.
  bool optimal = false;            ///< No tour is shorter.
  double bound = 0;                ///< No tour is shorter than this, metres; path.length where `optimal`.
  bool stopped = false;            ///< `watch` ended the search.
  std::optional<Point> outside;    ///< The first place at which the path leaves the workspace, see FirstOutside.
};

/// The shortest tour, every leg the shortest path inside the workspace. Up to `most_exact` tasks by FindExactTour, and
/// the order is the first of the shortest as in a dictionary; beyond by ImproveTour with BoundTour below it. A task on
/// a place where the boundary touches itself can be reached from each side, in classes of its own: it is visited from
/// the side that is nearer to the start, and the bound is for all sides. Errors: kStartOutside, kGoalOutside,
/// kTaskOutside with all such tasks. Cost: a taut curve for each pair of places, and the search.
tl::expected<Tour, OutsideFault> PlanTour(const WorkspaceRegion& region, const TourStops& stops,
                                          const TourOptions& options, Rng& rng);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_TOUR_H_
