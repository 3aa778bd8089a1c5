// Why there is no workspace, as one sentence that names the anchors.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_EXPLAIN_WORKSPACE_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_EXPLAIN_WORKSPACE_H_

#include <string>

#include "tautline/planners/cable_workspace/boundary.h"

namespace tautline {

/// The sentence for a fault of a boundary; its own `explanation` is not looked at. Anchors are counted from 1.
std::string ExplainBoundary(const CableGround& ground, const Anchors& anchors, const BoundaryFault& fault);

/// "the side from anchor 2 to anchor 3".
std::string SideName(std::size_t side, std::size_t anchors);

/// "the start (1, 2) is outside of the workspace, 0.3 m away from it"; `what` is "the start".
std::string ExplainOutside(const WorkspaceBoundary& boundary, const std::string& what, Point at);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_EXPLAIN_WORKSPACE_H_
