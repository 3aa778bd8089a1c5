// What the cables of a scene must be for a planner, however the scene was built.
#ifndef TAUTLINE_SCENE_CHECK_CABLES_H_
#define TAUTLINE_SCENE_CHECK_CABLES_H_

#include "tautline/base/error.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// Checks what readers check in files, for cables that were built in C++: three anchors or more, finite coordinates up
/// to kLargestCoordinate, as many laid cables as anchors, all from one point to their anchors up to SamePointTolerance,
/// and not both laid cables and words. Errors: kInvalidInput, and kLimitExceeded for large numbers; the message names
/// the part as a scene file would. O(points).
[[nodiscard]] Expected<void> CheckCables(const Cables& cables, const Box& world);

/// That the scene has cables without a fault. The errors say how to add them, or those of CheckCables.
[[nodiscard]] Expected<void> RequireCables(const Scene& scene);

/// The same, and that the scene says how they lie: laid, or the words of the boundary.
[[nodiscard]] Expected<void> RequireLaidCables(const Scene& scene);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_CHECK_CABLES_H_
