// What a fleet must be for a planner, however the scene was built.
#ifndef TAUTLINE_SCENE_CHECK_FLEET_H_
#define TAUTLINE_SCENE_CHECK_FLEET_H_

#include "tautline/base/error.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// Checks what readers check in files, for fleets that were built in C++: there is a robot; names are not empty and
/// unique; coordinates are finite and go up to kLargestCoordinate; speeds are positive, radii and tethers not negative,
/// all finite; a cable begins at its robot's start and ends at its target, up to SamePointTolerance. Besides, no two of
/// all starts and targets are one point: cables could not tell them apart. Errors: kInvalidInput, and kLimitExceeded
/// for large numbers; the message names the part as a scene file would. O(n log n + points of the cables).
[[nodiscard]] Expected<void> CheckFleet(const Fleet& fleet);

/// That the scene has a fleet without a fault. The errors say how to add one, or those of CheckFleet.
[[nodiscard]] Expected<void> RequireFleet(const Scene& scene);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_CHECK_FLEET_H_
