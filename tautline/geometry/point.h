// Points of the plane: x to the right, y up, metres.
#ifndef TAUTLINE_GEOMETRY_POINT_H_
#define TAUTLINE_GEOMETRY_POINT_H_

#include <cmath>
#include <compare>

namespace tautline {

/// A point, or the vector to it. Ordered by x, then y.
struct Point {
  double x = 0;  ///< Metres, to the right.
  double y = 0;  ///< Metres, up.

  /// By x, then y, exactly.
  friend constexpr auto operator<=>(const Point&, const Point&) = default;
};

/// The sum of two vectors.
constexpr Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
/// The vector from b to a.
constexpr Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
/// The vector s times as long.
constexpr Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }

/// The scalar product: positive when the angle between a and b is acute.
constexpr double Dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }

/// Positive when b is to the left of a. For decisions use Orientation (predicates.h), which is exact.
constexpr double Cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }

/// The length of a vector. Not by std::hypot, whose last bit differs between mathematics libraries: program and browser
/// would choose differently among ways of equal length. Coordinates go up to 1e15, so squares do not overflow.
inline double Norm(Point a) { return std::sqrt(Dot(a, a)); }
/// The distance between two points, metres.
inline double Distance(Point a, Point b) { return Norm(b - a); }

/// The point at fraction t of the way from a to b.
constexpr Point Lerp(Point a, Point b, double t) { return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; }

/// Whether both coordinates are finite numbers.
inline bool IsFinite(Point a) { return std::isfinite(a.x) && std::isfinite(a.y); }

}  // namespace tautline

#endif  // TAUTLINE_GEOMETRY_POINT_H_
