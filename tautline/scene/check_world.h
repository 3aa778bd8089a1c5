// What a world must be for free space to be made of it, however it was built.
#ifndef TAUTLINE_SCENE_CHECK_WORLD_H_
#define TAUTLINE_SCENE_CHECK_WORLD_H_

#include <cstddef>

#include "tautline/base/error.h"
#include "tautline/scene/free_space.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// The corners of a world: those of its outline, its polygons and the polygons made of its circles.
inline constexpr std::size_t kMaxWorldPoints = 4'000'000;

/// The corners of all pieces that growth by the clearance adds to a world.
inline constexpr std::size_t kMaxGrownPoints = 64'000'000;

/// The smallest FreeSpaceOptions::arc_error; a circle has 2222 corners then.
inline constexpr double kSmallestArcError = 1e-6;

/// Checks what readers check in files, for worlds that were built in C++: there is an outline; every obstacle has
/// exactly one shape; rings have three points, an area and do not cross themselves; circles have a radius;
/// representatives lie inside; clearance and snap are not negative; coordinates are finite and go up to
/// kLargestCoordinate; arc_error lies between kSmallestArcError and 1. Of obstacles `from_map`, which come traced or
/// checked, only the coordinates are looked at. Errors: kInvalidInput, and kLimitExceeded for large coordinates and too
/// many points; the message names the part as a scene file would. O(n log n) as a rule.
[[nodiscard]] Expected<void> CheckWorld(const World& world, const FreeSpaceOptions& options = {});

}  // namespace tautline

#endif  // TAUTLINE_SCENE_CHECK_WORLD_H_
