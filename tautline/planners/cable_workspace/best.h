// The best ways to lay the cables: every valid boundary up to a length, largest area first [Wang2018, Sec. III-F,
// III-G].
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_BEST_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_BEST_H_

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tautline/base/stop.h"
#include "tautline/planners/cable_workspace/boundary.h"

namespace tautline {

/// What is asked of the boundaries, and when the search gives up.
struct BestOptions {
  double max_boundary = 0;          ///< Metres; no boundary is longer.
  std::vector<Point> tasks = {};    ///< Places that every boundary must hold, inside or on it.
  std::int64_t budget = 5'000'000;  ///< Classes, partial boundaries and joins after which the search ends incomplete.
  KeepGoing keep_going = {};        ///< Asked now and then; at a no the search ends as at the budget's end.
};

/// The valid boundaries that were found, and whether they are all.
struct BoundaryList {
  std::vector<WorkspaceBoundary> boundaries;        ///< Largest area first; equal areas by length, then by words.
  bool complete = false;                            ///< No valid boundary up to max_boundary is missing.
  double complete_length = 0;                       ///< None up to this length is missing, metres.
  std::optional<WorkspaceObstruction> obstruction;  ///< Where there is none: why.
};

/// All valid boundaries up to a length: one taut side per anchor to the next, together closed, null-homotopic and
/// weakly simple, with area inside. The limit is raised in steps, so that a search that ends early knows the shorter
/// boundaries. Sides count by their cost, length less refunds that cancel around a boundary (see RayTolls), which makes
/// the slack small: what the limit leaves beyond the cheapest sides. Each step lists the classes of each side that
/// spend up to half of the slack, and joins them as BoundaryFan does. Requires two anchors at least. The number of
/// classes grows exponentially with the slack; their joins cost O(triangles) each.
BoundaryList FindBoundaries(const CableGround& ground, const Anchors& anchors, const BestOptions& options);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_BEST_H_
