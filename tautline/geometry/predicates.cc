#include "tautline/geometry/predicates.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <optional>

namespace tautline {
namespace {

using Integer = boost::multiprecision::cpp_int;
using Integer128 = boost::multiprecision::int128_t;
using Integer256 = boost::multiprecision::int256_t;

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

/// The values as integers below 2^61 over one common power of two; nothing when they do not fit.
template <std::size_t N>
std::optional<std::array<std::int64_t, N>> ToSmallIntegers(const std::array<double, N>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::fabs(value));
  const int exponent = largest > 0 ? std::ilogb(largest) : 0;
  if (exponent < -900) return std::nullopt;  // The scale would overflow.
  const double scale = std::ldexp(1, 60 - exponent);
  std::array<std::int64_t, N> integers;
  for (std::size_t i = 0; i < N; ++i) {
    const double scaled = scale * values[i];
    integers[i] = static_cast<std::int64_t>(scaled);
    if (static_cast<double>(integers[i]) != scaled || (scaled == 0 && values[i] != 0)) return std::nullopt;
  }
  return integers;
}

/// Whether a - b is a double.
bool DifferenceIsExact(double a, double b) {
  // The part of each operand that the rounded difference has lost. [Shewchuk1997, two-diff]
  const double difference = a - b;
  const double b_virtual = a - difference, a_virtual = difference + b_virtual;
  return a - a_virtual == 0 && b_virtual - b == 0;
}

/// The sign of p * q - r * s, exactly; nothing when a product is so small or large that its rest is no double.
std::optional<int> CompareProducts(double p, double q, double r, double s) {
  const double left = p * q, right = r * s;
  const auto has_rest = [](double product) { return std::fabs(product) > 1e-250 && std::fabs(product) < 1e250; };
  if (!has_rest(left) || !has_rest(right)) return std::nullopt;
  // Rounding keeps the order, so only equal rounded products leave it to what rounding took away.
  if (left != right) return left > right ? 1 : -1;
  const double left_rest = std::fma(p, q, -left), right_rest = std::fma(r, s, -right);
  return left_rest > right_rest ? 1 : left_rest < right_rest ? -1 : 0;
}

bool DifferencesAreExact(Point a, Point b) { return DifferenceIsExact(a.x, b.x) && DifferenceIsExact(a.y, b.y); }

/// InCircle of the points (x, y) given one after the other, and the origin. Requires |coordinate| < 2^62.
int SmallInCircle(const std::array<std::int64_t, 6>& points) {
  const auto [ax, ay, bx, by, cx, cy] = points;
  // A sum of two products stays within 2^125, the determinant within 3 * 2^250.
  const auto square = [](std::int64_t x, std::int64_t y) { return Integer128(x) * x + Integer128(y) * y; };
  const auto cross = [](std::int64_t px, std::int64_t py, std::int64_t qx, std::int64_t qy) {
    return Integer128(px) * qy - Integer128(qx) * py;
  };
  const Integer256 det = Integer256(square(ax, ay)) * cross(bx, by, cx, cy) +
                         Integer256(square(bx, by)) * cross(cx, cy, ax, ay) +
                         Integer256(square(cx, cy)) * cross(ax, ay, bx, by);
  return det.sign();
}

int BigInCircle(Point a, Point b, Point c, Point d) {
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

bool InClosedBox(Point a, Point b, Point p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

}  // namespace

namespace internal {

int ExactOrientation(Point a, Point b, Point c) {
  // Coordinates on a common grid of moderate size have exact differences.
  if (DifferenceIsExact(a.x, c.x) && DifferenceIsExact(b.y, c.y) && DifferenceIsExact(a.y, c.y) &&
      DifferenceIsExact(b.x, c.x)) {
    if (const auto sign = CompareProducts(a.x - c.x, b.y - c.y, a.y - c.y, b.x - c.x)) return *sign;
  }
  const double values[6] = {a.x, a.y, b.x, b.y, c.x, c.y};
  Integer v[6];
  ToCommonScale(values, v);
  const Integer det = (v[0] - v[4]) * (v[3] - v[5]) - (v[1] - v[5]) * (v[2] - v[4]);
  return det.sign();
}

int ExactInCircle(Point a, Point b, Point c, Point d) {
  // Points of a raster and points far from the origin have exact differences, others like coordinates; both fit into
  // integers of a fixed width, which need no memory from the heap.
  if (DifferencesAreExact(a, d) && DifferencesAreExact(b, d) && DifferencesAreExact(c, d)) {
    const Point u = a - d, v = b - d, w = c - d;
    if (const auto s = ToSmallIntegers(std::array{u.x, u.y, v.x, v.y, w.x, w.y})) return SmallInCircle(*s);
  }
  if (const auto s = ToSmallIntegers(std::array{a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y})) {
    const auto [ax, ay, bx, by, cx, cy, dx, dy] = *s;
    return SmallInCircle({ax - dx, ay - dy, bx - dx, by - dy, cx - dx, cy - dy});
  }
  return BigInCircle(a, b, c, d);
}

int ExactCompareCrossings(Point a, Point b, Point c, Point d, Point e, Point f) {
  const double values[12] = {a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y, e.x, e.y, f.x, f.y};
  Integer v[12];
  ToCommonScale(values, v);
  // Twice the area of the triangle c, d, p for the points of these positions.
  const auto area = [&v](int from, int to, int p) -> Integer {
    return (v[to] - v[from]) * (v[p + 1] - v[from + 1]) - (v[to + 1] - v[from + 1]) * (v[p] - v[from]);
  };
  const Integer ca = area(4, 6, 0), cb = area(4, 6, 2), ea = area(8, 10, 0), eb = area(8, 10, 2);
  const Integer difference = ea * cb - ca * eb;
  return difference.sign() * ca.sign() * ea.sign();
}

}  // namespace internal

namespace {

/// Twice the area of the triangle c, d, p, and a bound of its rounding error.
struct RoundedArea {
  RoundedArea(Point c, Point d, Point p) {
    const double left = (d.x - c.x) * (p.y - c.y), right = (d.y - c.y) * (p.x - c.x);
    value = left - right;
    error = 4e-16 * (std::fabs(left) + std::fabs(right));
  }
  double value, error;
};

}  // namespace

int CompareCrossings(Point a, Point b, Point c, Point d, Point e, Point f) {
  // The crossing with cd is at the share ca / (ca - cb) of ab, that with ef at ea / (ea - eb).
  const RoundedArea ca(c, d, a), cb(c, d, b), ea(e, f, a), eb(e, f, b);
  const double left = ea.value * cb.value, right = ca.value * eb.value;
  const double difference = left - right;
  const double bound = 1.001 * (std::fabs(ea.value) * cb.error + std::fabs(cb.value) * ea.error + ea.error * cb.error +
                                std::fabs(ca.value) * eb.error + std::fabs(eb.value) * ca.error + ca.error * eb.error) +
                       4e-16 * (std::fabs(left) + std::fabs(right));
  if (std::fabs(difference) <= bound || std::fabs(ca.value) <= ca.error || std::fabs(ea.value) <= ea.error) {
    return internal::ExactCompareCrossings(a, b, c, d, e, f);
  }
  const bool same_side = (ca.value > 0) == (ea.value > 0);
  return (difference > 0) == same_side ? 1 : -1;
}

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

bool WithinTurn(Point apex, Point a, Point b, Point p) {
  const bool left_of_a = Orientation(apex, a, p) > 0, right_of_b = Orientation(apex, b, p) < 0;
  return Orientation(apex, a, b) > 0 ? left_of_a && right_of_b : left_of_a || right_of_b;
}

}  // namespace tautline
