// The ways that robots drive: their shortest paths, and their cable lines.
#ifndef TAUTLINE_PLANNERS_FLEET_ROBOT_PATHS_H_
#define TAUTLINE_PLANNERS_FLEET_ROBOT_PATHS_H_

#include <vector>

#include "tautline/planners/fleet/fleet_plan.h"

namespace tautline {

/// The shortest path of each robot, by RobotId: its cable line pulled taut with all other robots gone
/// [Zhang2019, App. C]. In the plane it is straight; among obstacles it bends around corners, and its route lists those
/// that it grazes as well, each with the side of its obstacle. Requires a layout of this ground. Cost: as Shorten for
/// each robot.
std::vector<RobotPath> ShortestPaths(const FleetGround& ground, const FleetLayout& layout);

/// The cable line of a robot as a way to drive. O(points).
RobotPath CablePath(const FleetGround& ground, const FleetLayout& layout, RobotId robot);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_ROBOT_PATHS_H_
