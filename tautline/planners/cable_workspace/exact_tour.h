// The shortest order of a few tasks, exactly.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_EXACT_TOUR_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_EXACT_TOUR_H_

#include <vector>

#include "tautline/planners/cable_workspace/tour_distances.h"

namespace tautline {

/// The most tasks that FindExactTour takes: its memory doubles with each.
inline constexpr std::size_t kMostExactTasks = 15;

/// An order of all tasks whose tour is the shortest; among those that are as short but for rounding the first as in a
/// dictionary. Dynamic programming over the sets of tasks that are done [HeldKarp1962]. Requires at most
/// kMostExactTasks tasks. O(tasks^2 * 2^tasks).
std::vector<std::size_t> FindExactTour(const TourDistances& distances);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_EXACT_TOUR_H_
