// The shortest paths of a robot inside its workspace [Wang2018, Sec. V-A].
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_REGION_PATH_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_REGION_PATH_H_

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tautline/planners/cable_workspace/region.h"

namespace tautline {

/// Why there is no motion or tour: a place of it is not in the workspace.
struct OutsideFault {
  /// kStartOutside, kGoalOutside or kTaskOutside.
  WorkspaceObstruction obstruction = WorkspaceObstruction::kNone;
  std::vector<std::size_t> tasks = {};  ///< All tasks that are outside, by position.
  std::string explanation;              ///< One sentence, without a full stop.
};

/// The shortest path from one place of a workspace to another.
struct RegionPath {
  TautPath path;     ///< From start to goal.
  std::size_t from;  ///< Which of the start's ways it continues.
  std::size_t to;    ///< Which of the goal's ways it ends in.
};

/// The shortest path over all pairs of ways (see WorkspaceRegion::WaysTo), the first pair among equals. Requires a way
/// to each. One taut curve per pair.
RegionPath ShortestPath(const WorkspaceRegion& region, std::span<const Walk> from_ways, std::span<const Walk> to_ways);

/// The first place at which a path leaves the workspace; nothing as a rule. Where all anchors stand on the boundary of
/// the free ground, each side cuts the cover in two, and a taut curve, which crosses another one once at most, does not
/// leave and come back. An anchor in the open, at which the boundary turns inwards, lets it out on one of its sides and
/// in on the other. Places within the tolerance of the space count as inside. O(points of the path * (corners of the
/// boundary
/// + crossings)).
std::optional<Point> FirstOutside(const WorkspaceRegion& region, std::span<const Point> path);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_REGION_PATH_H_
