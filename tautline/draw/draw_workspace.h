// The pictures of a workspace and of the robot in it.
#ifndef TAUTLINE_DRAW_DRAW_WORKSPACE_H_
#define TAUTLINE_DRAW_DRAW_WORKSPACE_H_

#include <string>
#include <vector>

#include "tautline/planners/cable_workspace/boundary.h"
#include "tautline/planners/cable_workspace/pose.h"

namespace tautline {

/// What the picture of a boundary shows.
struct WorkspacePicture {
  const Anchors& anchors;                                          ///< Of all cables.
  const tl::expected<WorkspaceBoundary, BoundaryFault>& boundary;  ///< Or what is wrong with it.
  const std::vector<LongestCable>& longest;                        ///< By anchor; empty without a boundary.
};

/// The workspace with its boundary, the winches and the cables as laid; or, where there is none, the sides with those
/// at fault marked. Deterministic.
std::string DrawWorkspace(const Scene& scene, const FreeSpace& space, const WorkspacePicture& picture);

/// What the picture of a pose shows.
struct PosePicture {
  const Anchors& anchors;                                          ///< Of all cables.
  const tl::expected<WorkspaceBoundary, BoundaryFault>& boundary;  ///< Or what is wrong with it.
  Point at;                                                        ///< The pose.
  const Pose& pose;                                                ///< As it was found.
};

/// The robot at a pose with its taut cables, in its workspace. Requires a boundary. Deterministic.
std::string DrawPose(const Scene& scene, const FreeSpace& space, const PosePicture& picture);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_WORKSPACE_H_
