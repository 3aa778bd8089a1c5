// The classes of one side of a boundary that are cheap enough.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_SIDE_CLASSES_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_SIDE_CLASSES_H_

#include <vector>

#include "tautline/homotopy/taut_path.h"
#include "tautline/planners/cable_workspace/ray_tolls.h"
#include "tautline/planners/cable_workspace/search_budget.h"

namespace tautline {

/// Which classes are listed.
struct SideClassOptions {
  double max_cost = 0;             ///< Metres; no class costs more: its length less its refund.
  double max_length = 0;           ///< Metres; and none is longer.
  bool drop_crossing = false;      ///< Paths whose legs cross are left out, with all that go on from them.
  bool drop_loops = false;         ///< So are paths that come by a corner twice on the same side of its obstacle.
  SearchBudget* budget = nullptr;  ///< Spends a step for each part of a path.
};

/// Whether paths between two places that come by a corner twice, with its obstacle on the same side, cross themselves:
/// between, they close a loop around one of their ends, or cross. Known where both ends are on the wall around the free
/// space, which no loop in it is around. O(boundary edges).
bool LoopsCross(const TautSpace& space, const Place& from, const Place& to);

/// The taut paths of a side, from exit to exit, in no special order. A path is followed corner by corner as long as the
/// cheapest way on costs no more, and the shortest taut way on is no longer, than what is left. O(corners of the path)
/// per part of a path. Throws Stopped when the budget is spent.
std::vector<TautPath> ListSideClasses(const TautSpace& space, const Anchors& anchors, std::size_t side,
                                      const TollGraph& graph, const RayTolls& tolls, const SideClassOptions& options);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_SIDE_CLASSES_H_
