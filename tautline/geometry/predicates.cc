#include "tautline/geometry/predicates.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>

namespace tautline {
namespace {

using Integer = boost::multiprecision::cpp_int;

/// A finite double as mantissa * 2^exponent with an integer mantissa; zero has a large exponent so that it never
/// decides the common scale.
struct Dyadic {
  std::int64_t mantissa;
  int exponent;
};

Dyadic ToDyadic(double value) {
  if (value == 0) return {0, 4096};
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return {static_cast<std::int64_t>(std::ldexp(fraction, 53)), exponent - 53};
}

/// The given coordinates as integers over one common power of two.
template <std::size_t N>
void ToCommonScale(const double (&values)[N], Integer (&integers)[N]) {
  Dyadic dyadic[N];
  int least = 4096;
  for (std::size_t i = 0; i < N; ++i) {
    dyadic[i] = ToDyadic(values[i]);
    least = std::min(least, dyadic[i].exponent);
  }
  for (std::size_t i = 0; i < N; ++i) {
    integers[i] = dyadic[i].mantissa;
    if (dyadic[i].mantissa != 0) integers[i] <<= static_cast<unsigned>(dyadic[i].exponent - least);
  }
}

bool InClosedBox(Point a, Point b, Point p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

}  // namespace

namespace internal {

int ExactOrientation(Point a, Point b, Point c) {
  const double values[6] = {a.x, a.y, b.x, b.y, c.x, c.y};
  Integer v[6];
  ToCommonScale(values, v);
  const Integer det = (v[0] - v[4]) * (v[3] - v[5]) - (v[1] - v[5]) * (v[2] - v[4]);
  return det.sign();
}

int ExactInCircle(Point a, Point b, Point c, Point d) {
  const double values[8] = {a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y};
  Integer v[8];
  ToCommonScale(values, v);
  const Integer ax = v[0] - v[6], ay = v[1] - v[7];
  const Integer bx = v[2] - v[6], by = v[3] - v[7];
  const Integer cx = v[4] - v[6], cy = v[5] - v[7];
  const Integer det = (ax * ax + ay * ay) * (bx * cy - cx * by) + (bx * bx + by * by) * (cx * ay - ax * cy) +
                      (cx * cx + cy * cy) * (ax * by - bx * ay);
  return det.sign();
}

}  // namespace internal

int InCircle(Point a, Point b, Point c, Point d) {
  const double ax = a.x - d.x, ay = a.y - d.y;
  const double bx = b.x - d.x, by = b.y - d.y;
  const double cx = c.x - d.x, cy = c.y - d.y;
  const double bc = bx * cy, cb = cx * by;
  const double ca = cx * ay, ac = ax * cy;
  const double ab = ax * by, ba = bx * ay;
  const double a2 = ax * ax + ay * ay, b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const double det = a2 * (bc - cb) + b2 * (ca - ac) + c2 * (ab - ba);
  const double permanent = a2 * (std::fabs(bc) + std::fabs(cb)) + b2 * (std::fabs(ca) + std::fabs(ac)) +
                           c2 * (std::fabs(ab) + std::fabs(ba));
  // Shewchuk's bound for the first stage of incircle: (10 + 96 eps) eps with eps = 2^-53.
  const double bound = 1.1102230246251577e-15 * permanent;
  if (det > bound) return 1;
  if (det < -bound) return -1;
  return internal::ExactInCircle(a, b, c, d);
}

bool OnSegment(Point a, Point b, Point p) { return InClosedBox(a, b, p) && Orientation(a, b, p) == 0; }

bool CrossProperly(Point a, Point b, Point c, Point d) {
  return Orientation(a, b, c) * Orientation(a, b, d) < 0 && Orientation(c, d, a) * Orientation(c, d, b) < 0;
}

}  // namespace tautline
