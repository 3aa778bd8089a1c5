// The picture and the film of a drive with a simulated cable.
#ifndef TAUTLINE_DRAW_DRAW_DRIVE_H_
#define TAUTLINE_DRAW_DRAW_DRIVE_H_

#include <string>
#include <vector>

#include "tautline/planners/grid_manifold/drive_trace.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// What there is to see of a drive.
struct DrivePicture {
  std::vector<DriveFrame> frames;  ///< In order; empty where the drive could not begin.
  std::vector<Contact> contacts;   ///< In the order in which they began.
  std::vector<GoalOutcome> goals;  ///< In order.
  double robot_radius_m = 0.17;    ///< Of the disc.
  std::string explanation;         ///< Why it did not succeed; may be empty.
};

/// The picture, as SVG: the way of the robot, the cable as it lies in the end, what touched the cable, the goals in
/// order. Requires a world with a free space and a tether. Deterministic.
std::string DrawDrive(const Scene& scene, const DrivePicture& picture);

/// The same as a film: robot and cable move, over and over. A film of a drive that could not begin stands still.
/// Deterministic. O(frames * points of a cable²).
std::string AnimateDrive(const Scene& scene, const DrivePicture& picture);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_DRIVE_H_
