// Does an open curve cross itself; does it come into a ring; where does it meet another one.
#ifndef TAUTLINE_GEOMETRY_CURVE_CROSSING_H_
#define TAUTLINE_GEOMETRY_CURVE_CROSSING_H_

#include <cstddef>
#include <optional>
#include <span>

#include "tautline/geometry/point.h"

namespace tautline {

/// A place at which an open polyline passes from one side of itself to the other, if there is any: two segments cross
/// in a point inside both, or it passes through a point that it came through before, or it runs along itself, in either
/// direction, and comes off on the other side. Touching is no crossing, and neither is a run along itself that one of
/// the two ends lies on. Which there is one, is exact; the place is rounded. Requires finite points and that the
/// polyline nowhere turns back on the spot. O(n^2) and the length of the runs.
std::optional<Point> FindCurveCrossing(std::span<const Point> curve);

/// Whether the segment ab has a point strictly inside a simple ring of either orientation, three points or more and no
/// neighbours equal. Exact. O(n).
bool EntersRing(std::span<const Point> ring, Point a, Point b);

/// Where one polyline meets another one first.
struct CurveMeeting {
  std::size_t on_curve = 0;  ///< The segment of the one, by its first point.
  std::size_t on_other = 0;  ///< The segment of the other.
  Point at;                  ///< The place: a vertex of one of them as it is, or a crossing, rounded.
};

/// The first point of `curve` that `other` has, too. Whether there is one, and the segments, are exact but for points
/// of one segment that lie closer than rounding. O(n m).
std::optional<CurveMeeting> FindFirstMeeting(std::span<const Point> curve, std::span<const Point> other);

}  // namespace tautline

#endif  // TAUTLINE_GEOMETRY_CURVE_CROSSING_H_
