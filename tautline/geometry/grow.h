// Growth of polygons by a distance, as pieces whose union is the grown polygon.
#ifndef TAUTLINE_GEOMETRY_GROW_H_
#define TAUTLINE_GEOMETRY_GROW_H_

#include <span>
#include <vector>

#include "tautline/geometry/polygon.h"

namespace tautline {

/// Counter-clockwise rings that, united with the ground on the left of `ring`, contain every point within `radius`
/// metres of that ground and no point farther than radius * (1 + arc_error): a rectangle along each edge and, at each
/// convex corner, a fan whose outer polyline circumscribes the arc. Where the ring has no area, as in spikes, it grows
/// as the segment or the point that it is. Requires radius > 0 and arc_error in (0, 1]. O(n) rings.
std::vector<Ring> GrowthPieces(std::span<const Point> ring, double radius, double arc_error);

/// The corners of a regular polygon around a circle that is nowhere more than arc_error of the radius beyond it.
/// Requires arc_error in (0, 1], and far above the rounding of doubles: from 1e-9 on.
int CircleSides(double arc_error);

/// A regular polygon around the circle, nowhere more than radius * arc_error beyond it. Counter-clockwise.
Ring CircumscribedPolygon(Point centre, double radius, double arc_error);

}  // namespace tautline

#endif  // TAUTLINE_GEOMETRY_GROW_H_
