// The exact geometric decisions. Every orientation decision of tautline goes through this header.
#ifndef TAUTLINE_GEOMETRY_PREDICATES_H_
#define TAUTLINE_GEOMETRY_PREDICATES_H_

#include "tautline/geometry/point.h"

namespace tautline {

namespace internal {
/// The slow exact paths behind the filters below.
[[gnu::cold]] int ExactOrientation(Point a, Point b, Point c);
[[gnu::cold]] int ExactInCircle(Point a, Point b, Point c, Point d);
[[gnu::cold]] int ExactCompareCrossings(Point a, Point b, Point c, Point d, Point e, Point f);
}  // namespace internal

/// +1 when a, b, c turn left (counter-clockwise), -1 when they turn right, 0 when they are collinear. Exact for all
/// finite doubles whose products neither overflow nor underflow (|coordinate| between 1e-70 and 1e70, or zero).
/// Identities: Orientation(a,b,c) == Orientation(b,c,a) == -Orientation(b,a,c). [Shewchuk1997]
inline int Orientation(Point a, Point b, Point c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  // The rounding error of `det` is below 3.3306690738754716e-16 * (|left| + |right|).
  const double bound = 3.3306690738754716e-16 * (std::fabs(left) + std::fabs(right));
  if (det > bound) return 1;
  if (det < -bound) return -1;
  // Two points coincide, or all share a coordinate: common, and exact.
  if ((a.x == c.x || b.y == c.y) && (a.y == c.y || b.x == c.x)) return 0;
  return internal::ExactOrientation(a, b, c);
}

/// +1 when d is inside the circle through a, b, c (counter-clockwise), -1 outside, 0 on it. Exact as Orientation,
/// with |coordinate| between 1e-35 and 1e35, or zero.
int InCircle(Point a, Point b, Point c, Point d);

/// Whether p lies on the closed segment from a to b, exactly.
bool OnSegment(Point a, Point b, Point p);

/// Whether the open segments ab and cd cross in one point interior to both, exactly.
bool CrossProperly(Point a, Point b, Point c, Point d);

/// Which of two segments that both cross ab does so nearer to a: -1 when cd does, +1 when ef does, 0 when all three
/// meet in one point. Requires that a and b lie strictly on different sides of the lines through cd and through ef.
/// Exact as Orientation, with |coordinate| between 1e-35 and 1e35, or zero.
int CompareCrossings(Point a, Point b, Point c, Point d, Point e, Point f);

/// Whether the direction to p lies strictly within the left turn from the direction to a to that to b, all seen from
/// `apex`, exactly. Requires that a, b and p are not `apex` and that a and b are not in one direction.
bool WithinTurn(Point apex, Point a, Point b, Point p);

}  // namespace tautline

#endif  // TAUTLINE_GEOMETRY_PREDICATES_H_
