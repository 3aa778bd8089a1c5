// What a tether and a goal must be for a planner, however the scene was built.
#ifndef TAUTLINE_SCENE_CHECK_TETHER_H_
#define TAUTLINE_SCENE_CHECK_TETHER_H_

#include "tautline/base/error.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// How far apart two points of a scene may be that must be one point, metres: the rounding of printed coordinates.
/// `world` is the box around its outline; empty without one.
double SamePointTolerance(const Box& world);

/// Checks what readers check in files, for tethers that were built in C++: the length is finite and not negative, the
/// coordinates are finite and go up to kLargestCoordinate, a laid cable has a point and starts at the base, up to
/// SamePointTolerance. Errors: kInvalidInput, and kLimitExceeded for large numbers; the message names the part as a
/// scene file would. O(points of the cable).
[[nodiscard]] Expected<void> CheckTether(const Tether& tether, const Box& world);

/// The same for a goal, or for another point that is asked about; `what` is "goal".
[[nodiscard]] Expected<void> CheckGoal(Point goal, const char* what = "goal");

/// That the scene has a tether without a fault. The errors say how to add one, or those of CheckTether.
[[nodiscard]] Expected<void> RequireTether(const Scene& scene);

/// The same for a tether and a goal.
[[nodiscard]] Expected<void> RequireTetherAndGoal(const Scene& scene);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_CHECK_TETHER_H_
