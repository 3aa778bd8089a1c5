// The robot at one place of its workspace: its taut cables, and whether they can move it in every direction.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_POSE_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_POSE_H_

#include <optional>
#include <vector>

#include "tautline/planners/cable_workspace/region.h"

namespace tautline {

/// A taut cable at a pose.
struct PoseCable {
  TautPath path;                   ///< From the anchor's exit to the robot.
  double length = 0;               ///< With the stub, metres.
  std::optional<Point> direction;  ///< Unit vector in which it pulls; nothing when the robot is at the anchor.
};

/// The robot at a pose. [Wang2018, Sec. III-A to III-C]
struct Pose {
  Containment position = Containment::kOutside;  ///< By the boundary.
  std::vector<PoseCable> cables;                 ///< By anchor; empty outside.
  bool spans = false;      ///< The cables pull in directions that positively span the plane: it can move any way.
  double largest_gap = 0;  ///< The widest angle between neighbouring directions, radians; pi and more do not span.
  double margin = 0;       ///< The least, over all directions, of the share with which the best cable pulls that way:
                           ///< cos(largest_gap / 2). Positive where the directions span.
  bool touches_obstacle = false;  ///< On the boundary, the robot touches blocked ground.
};

/// Looks at a pose. Where the boundary touches itself, from the first of the ways there. The decision of `spans` is
/// exact for the corners that the cables come from. O(cables) taut curves.
Pose LookAtPose(const WorkspaceRegion& region, Point at);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_POSE_H_
