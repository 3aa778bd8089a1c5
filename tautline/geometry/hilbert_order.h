// An order of points in which neighbours in the order are neighbours in the plane.
#ifndef TAUTLINE_GEOMETRY_HILBERT_ORDER_H_
#define TAUTLINE_GEOMETRY_HILBERT_ORDER_H_

#include <cstdint>
#include <span>
#include <vector>

#include "tautline/geometry/point.h"

namespace tautline {

/// The positions 0, 1, ..., n-1 of the points, sorted along a Hilbert curve over their bounding box. Deterministic.
/// O(n log n).
std::vector<std::int32_t> HilbertOrder(std::span<const Point> points);

}  // namespace tautline

#endif  // TAUTLINE_GEOMETRY_HILBERT_ORDER_H_
