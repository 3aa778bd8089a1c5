// What a shape must be to bound a region: one set of rules for files and for worlds built in C++.
#ifndef TAUTLINE_SCENE_RING_CHECK_H_
#define TAUTLINE_SCENE_RING_CHECK_H_

#include <optional>
#include <span>

#include "tautline/geometry/polygon.h"
#include "tautline/scene/number_fault.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// The ring without points that repeat the one before, and without a last point that repeats the first.
Ring WithoutRepeats(std::span<const Point> points);

/// Whether the ring has three points or more that do not all lie on one line, to rounding.
bool HasArea(const Ring& ring);

/// Fewer than three points, or a coordinate that PointFault refuses. O(n).
std::optional<Fault> RingPointsFault(const Ring& ring);

/// As RingPointsFault; or the ring crosses itself, and the text names the edges; or it has no area. O(n log n) as a
/// rule.
std::optional<Fault> RingFault(const Ring& ring);

/// A hole of the polygon that reaches out of it: one of its points lies outside, or one of its edges crosses an edge of
/// the outer ring. Requires rings without a fault. O(n log n) as a rule.
std::optional<Fault> HolesFault(const PolygonWithHoles& polygon);

/// No radius, or a coordinate of the disc that PointFault refuses.
std::optional<Fault> CircleFault(const Circle& circle);

/// Both shapes or none.
std::optional<Fault> ShapeCountFault(bool has_polygon, bool has_circle);

/// A representative that does not lie strictly inside the obstacle. Requires one shape without a fault.
std::optional<Fault> RepresentativeFault(const Obstacle& obstacle);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_RING_CHECK_H_
