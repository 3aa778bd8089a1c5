// What a ring must be to bound a region.
#ifndef TAUTLINE_SCENE_RING_CHECK_H_
#define TAUTLINE_SCENE_RING_CHECK_H_

#include <span>
#include <string>

#include "tautline/geometry/polygon.h"
#include "tautline/scene/document.h"
#include "tautline/scene/field_reader.h"

namespace tautline {

/// The ring without points that repeat the one before, and without a last point that repeats the first.
Ring WithoutRepeats(std::span<const Point> points);

/// Whether the ring has three points or more that do not all lie on one line, to rounding.
bool HasArea(const Ring& ring);

/// Records an error in `reader` when the ring has no area or crosses itself; the latter names the edges.
void CheckRing(const Ring& ring, const std::string& what, Position at, FieldReader& reader);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_RING_CHECK_H_
