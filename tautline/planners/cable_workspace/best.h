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
  std::optional<WorkspaceObstruction> obstruction;  ///< Where there is none: why.
};

/// All valid boundaries up to a length: one taut side per anchor to the next, together closed, null-homotopic and
/// weakly simple, with area inside. The classes of each side come shortest first; partial boundaries that start at the
/// first anchor are joined in the middle with those that end there, where their products cancel. A part is pruned when
/// it, with the taut way back to the first anchor, is longer than the limit, or when it crosses itself.
BoundaryList FindBoundaries(const CableGround& ground, const Anchors& anchors, const BestOptions& options);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_BEST_H_
