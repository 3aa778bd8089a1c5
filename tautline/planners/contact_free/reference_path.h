// The path that a contact-free planner keeps near: the shortest one whose class the cable allows.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_REFERENCE_PATH_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_REFERENCE_PATH_H_

#include <cstdint>
#include <vector>

#include "tautline/geometry/polygon.h"
#include "tautline/homotopy/rays.h"

namespace tautline {

/// A path from the robot to the goal, and the tether that it leads to.
struct ReferencePath {
  Polyline path;               ///< From the robot to the goal, metres; taut, but for the paper's way.
  double length_m = 0;         ///< Of the path.
  Word word;                   ///< Of the path.
  Word tether_word;            ///< Of the cable at the goal: the laid one and the path.
  double tether_length_m = 0;  ///< Of the shortest curve from base to goal in that class.
};

/// The points of a path at most `spacing_m` apart, its own points included, the first one not: way-points that a robot
/// passes. Requires a positive spacing. O(points).
Polyline Waypoints(const Polyline& path, double spacing_m);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_REFERENCE_PATH_H_
