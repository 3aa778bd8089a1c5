// A robot and the cable behind it, in motion.
#ifndef TAUTLINE_DRAW_MOVING_ROBOT_H_
#define TAUTLINE_DRAW_MOVING_ROBOT_H_

#include <span>

#include "tautline/draw/figure.h"
#include "tautline/planners/grid_manifold/drive_trace.h"

namespace tautline {

/// A cable as it lies on the floor.
inline const LineStyle kLaidCableLine = {.colour = "#8f6400", .width = 2.6};
/// The robot's disc.
inline constexpr char kRobotColour[] = "#0b4a8f";

/// Draws the frames as a film that runs over and over, faster than the motion was. Requires a frame, and cables that
/// are not empty. O(frames * points of a cable²).
void DrawMovingRobot(Figure& figure, std::span<const DriveFrame> frames, double robot_radius_m);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_MOVING_ROBOT_H_
