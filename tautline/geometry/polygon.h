// Rings, polylines and polygons with holes as plain values.
#ifndef TAUTLINE_GEOMETRY_POLYGON_H_
#define TAUTLINE_GEOMETRY_POLYGON_H_

#include <span>
#include <vector>

#include "tautline/geometry/point.h"

namespace tautline {

/// A closed polygonal curve; the last point is joined to the first and not repeated.
using Ring = std::vector<Point>;

/// An open polygonal curve.
using Polyline = std::vector<Point>;

/// A region bounded by `outer` without the regions bounded by `holes`. Orientations are free; operations that need
/// one say so.
struct PolygonWithHoles {
  Ring outer;               ///< Around the region.
  std::vector<Ring> holes;  ///< Cut out of it.

  /// Whether both list the same points in the same order.
  friend bool operator==(const PolygonWithHoles&, const PolygonWithHoles&) = default;
};

/// An axis-aligned box, metres; empty (low > high) until something is added.
struct Box {
  Point low{1e300, 1e300};     ///< The lower left corner.
  Point high{-1e300, -1e300};  ///< The upper right corner.

  /// Grows the box just so that it holds p.
  void Add(Point p);
  /// Whether nothing was added.
  bool empty() const { return low.x > high.x; }
  /// Width and height, metres. Requires a box that is not empty.
  Point size() const { return high - low; }
  /// The middle. Requires a box that is not empty.
  Point centre() const { return 0.5 * (low + high); }
};

/// The smallest box that holds all points; empty when there are none. O(n).
Box BoundingBox(std::span<const Point> points);

/// The area of the ring in square metres: positive when it runs counter-clockwise. Summed about the first point, so
/// that far-away rings keep their digits.
double SignedArea(std::span<const Point> ring);

/// The length of an open polyline, metres.
double Length(std::span<const Point> polyline);

/// How a ring winds around a point.
struct Winding {
  int number = 0;            ///< Turns, counter-clockwise positive; without meaning on the boundary.
  bool on_boundary = false;  ///< The point lies on the ring.
};

/// How often the ring winds around p. Exact. O(n).
Winding WindingNumber(std::span<const Point> ring, Point p);

/// Whether p is inside or on the boundary of the ring (non-zero winding).
bool ContainsPoint(std::span<const Point> ring, Point p);

/// Whether p is strictly inside the polygon and in none of its holes.
bool StrictlyInside(const PolygonWithHoles& polygon, Point p);

/// A point strictly inside the polygon: the centroid when it is inside, otherwise the middle of the longest free
/// interval on the horizontal line through the middle between two neighbouring vertex heights. Requires positive area.
Point InteriorPoint(const PolygonWithHoles& polygon);

/// The distance from p to the closed segment ab, metres.
double DistanceToSegment(Point p, Point a, Point b);

/// The point of the closed segment ab that is nearest to p.
Point NearestOnSegment(Point p, Point a, Point b);

/// The ring without repeated neighbours and without vertices at which it goes straight on, exactly. Spikes stay.
Ring DropStraight(std::span<const Point> ring);

/// The ring without repeated neighbours and without vertices that are exactly collinear with theirs. Spikes go; fewer
/// than three points are left of a ring that has no area.
Ring DropCollinear(std::span<const Point> ring);

}  // namespace tautline

#endif  // TAUTLINE_GEOMETRY_POLYGON_H_
