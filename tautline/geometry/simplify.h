// Fewer corners for traced outlines, erring on the side of the obstacles.
#ifndef TAUTLINE_GEOMETRY_SIMPLIFY_H_
#define TAUTLINE_GEOMETRY_SIMPLIFY_H_

#include <span>
#include <vector>

#include "tautline/geometry/polygon.h"

namespace tautline {

/// The polygons with fewer vertices, such that
///   - every point of a polygon stays in it: regions only grow;
///   - no boundary moves by more than `tolerance_m` (> 0): the Hausdorff distance between the old and the new piece of
///     boundary is within it;
///   - nothing meets that did not meet before: no passage closes, no hole vanishes, no two polygons merge.
/// By construction: a vertex is dropped only where the region turns inwards, only while the triangle that this adds
/// holds no other vertex of any ring, and only while all original vertices between its neighbours stay within the
/// tolerance of the new edge. Requires outer rings counter-clockwise and holes clockwise, no ring that crosses itself
/// or another (touching at vertices is fine), no repeated neighbours. Small triangles go first; the order is the same
/// on every machine. O(n log n) for outlines of cells.
std::vector<PolygonWithHoles> SimplifyOutwards(std::span<const PolygonWithHoles> polygons, double tolerance_m);

}  // namespace tautline

#endif  // TAUTLINE_GEOMETRY_SIMPLIFY_H_
