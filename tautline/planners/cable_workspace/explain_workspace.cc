#include "tautline/planners/cable_workspace/explain_workspace.h"

#include <algorithm>
#include <limits>

#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

std::string Number(std::size_t anchor) { return std::to_string(anchor + 1); }

}  // namespace

std::string ToString(WorkspaceObstruction obstruction) {
  switch (obstruction) {
    case WorkspaceObstruction::kNone:
      return "";
    case WorkspaceObstruction::kRobotBlocked:
      return "robot_blocked";
    case WorkspaceObstruction::kLaidCableBlocked:
      return "laid_cable_blocked";
    case WorkspaceObstruction::kAnchorsUnconnected:
      return "anchors_unconnected";
    case WorkspaceObstruction::kNoSuchClass:
      return "no_such_class";
    case WorkspaceObstruction::kNotClosed:
      return "boundary_not_closed";
    case WorkspaceObstruction::kCrossesItself:
      return "boundary_crosses_itself";
    case WorkspaceObstruction::kNoArea:
      return "workspace_empty";
    case WorkspaceObstruction::kNoBoundary:
      return "no_boundary";
    case WorkspaceObstruction::kStartOutside:
      return "start_outside";
    case WorkspaceObstruction::kGoalOutside:
      return "goal_outside";
    case WorkspaceObstruction::kTaskOutside:
      return "task_outside";
    case WorkspaceObstruction::kPoseOutside:
      return "pose_outside";
    case WorkspaceObstruction::kAnchorBlocked:
      return "anchor_blocked";
    case WorkspaceObstruction::kTooTangled:
      return "too_tangled";
  }
  return "";
}

std::string SideName(std::size_t side, std::size_t anchors) {
  return "the side from anchor " + Number(side) + " to anchor " + Number(NextAnchor(side, anchors));
}

std::string ExplainBoundary(const CableGround& ground, const Anchors& anchors, const BoundaryFault& fault) {
  const std::size_t n = anchors.size();
  switch (fault.obstruction) {
    case WorkspaceObstruction::kRobotBlocked:
      return "the robot " + ToText(*fault.at) + " stands " + BlockedText(ground.space().free_space());
    case WorkspaceObstruction::kLaidCableBlocked:
      if (const auto place = ground.space().Locate(*fault.at);
          place && ground.space().mesh().Sectors(*place).size() > 1) {
        return "the cable of anchor " + Number(fault.sides[0]) + " as laid cannot pass at " + ToText(*fault.at) +
               ": blocked ground touches there";
      }
      return "the cable of anchor " + Number(fault.sides[0]) + " as laid leaves the free ground at " +
             ToText(*fault.at) + ": that place is " + BlockedText(ground.space().free_space());
    case WorkspaceObstruction::kAnchorsUnconnected:
      return SideName(fault.sides[0], n) + " cannot be: no free ground leads from " +
             ToText(anchors[fault.sides[0]].base) + " to " + ToText(anchors[NextAnchor(fault.sides[0], n)].base);
    case WorkspaceObstruction::kNoSuchClass:
      return SideName(fault.sides[0], n) + " cannot be: no free path between the two has its word";
    case WorkspaceObstruction::kNotClosed:
      return "the words of the sides, one after the other, do not cancel to the empty word: obstacles are caught "
             "inside, "
             "and no robot's cables can lie so";
    case WorkspaceObstruction::kCrossesItself:
      return fault.sides.size() == 1
                 ? SideName(fault.sides[0], n) + " crosses itself"
                 : SideName(fault.sides[0], n) + " crosses " + SideName(fault.sides[1], n) +
                       ": if the cables are meant so, check that the anchors are listed in order around the outline";
    case WorkspaceObstruction::kNoArea:
      return "the boundary holds no area: the cables leave the robot no room to move";
    default:
      return "";
  }
}

std::string ExplainOutside(const WorkspaceBoundary& boundary, const std::string& what, Point at) {
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < boundary.ring.size(); ++i) {
    distance =
        std::min(distance, DistanceToSegment(at, boundary.ring[i], boundary.ring[(i + 1) % boundary.ring.size()]));
  }
  return what + " " + ToText(at) + " is outside of the workspace, " + Metres(distance) + " away from it";
}

}  // namespace tautline
