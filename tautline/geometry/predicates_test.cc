#include "tautline/geometry/predicates.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"

namespace tautline {
namespace {

using Rational = boost::multiprecision::cpp_rational;

int Sign(const Rational& value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

int SlowOrientation(Point a, Point b, Point c) {
  const Rational ax(a.x), ay(a.y), bx(b.x), by(b.y), cx(c.x), cy(c.y);
  return Sign((bx - ax) * (cy - ay) - (by - ay) * (cx - ax));
}

int SlowInCircle(Point a, Point b, Point c, Point d) {
  const auto row = [d](Point p) {
    const Rational x = Rational(p.x) - Rational(d.x), y = Rational(p.y) - Rational(d.y);
    return std::array<Rational, 3>{x, y, x * x + y * y};
  };
  const auto u = row(a), v = row(b), w = row(c);
  return Sign(u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
              u[2] * (v[0] * w[1] - v[1] * w[0]));
}

/// The value moved by up to two units in its last place.
double Nudged(Rng& rng, double value) {
  const int steps = rng.UniformInt(-2, 2);
  for (int i = 0; i < std::abs(steps); ++i) value = std::nextafter(value, steps * HUGE_VAL);
  return value;
}

Point Nudged(Rng& rng, Point p) { return {Nudged(rng, p.x), Nudged(rng, p.y)}; }

Point RandomPoint(Rng& rng, double scale) {
  if (rng.UniformInt(0, 2) == 0) return scale * Point{1.0 * rng.UniformInt(-4, 4), 1.0 * rng.UniformInt(-4, 4)};
  return {rng.Uniform(-scale, scale), rng.Uniform(-scale, scale)};
}

/// Anywhere, or within a few ulps of the line through a and b.
Point NearLine(Rng& rng, Point a, Point b, double scale) {
  if (rng.UniformInt(0, 2) == 0) return RandomPoint(rng, scale);
  return Nudged(rng, a + rng.Uniform(-2, 2) * (b - a));
}

TEST(Predicates, OrientationIsExactAndAntisymmetric) {
  const std::int64_t count = ScaledTestCount(20000);
  int zeros = 0;
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const double scale = std::ldexp(1, rng.UniformInt(-200, 200));
    const Point a = RandomPoint(rng, scale), b = RandomPoint(rng, scale), c = NearLine(rng, a, b, scale);
    const int turn = Orientation(a, b, c);
    ASSERT_EQ(turn, SlowOrientation(a, b, c));
    ASSERT_EQ(turn, Orientation(b, c, a));
    ASSERT_EQ(turn, -Orientation(b, a, c));
    ASSERT_EQ(turn, internal::ExactOrientation(a, b, c));
    ASSERT_EQ(Orientation(a, b, a), 0);
    zeros += turn == 0 ? 1 : 0;
  }
  EXPECT_GT(zeros, count / 200);
}

TEST(Predicates, OrientationTellsUlpsApartFarFromTheOrigin) {
  const Point a{1e9, 1e9}, b{2e9, 2e9}, c{3e9, 3e9};
  EXPECT_EQ(Orientation(a, b, c), 0);
  EXPECT_EQ(Orientation(a, b, {c.x, std::nextafter(c.y, 4e9)}), 1);
  EXPECT_EQ(Orientation(a, b, {c.x, std::nextafter(c.y, 0)}), -1);
}

TEST(Predicates, OrientationOfVeryDifferentMagnitudes) {
  const std::int64_t count = ScaledTestCount(3000);
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const auto any = [&rng] { return RandomPoint(rng, std::ldexp(1, rng.UniformInt(-200, 200))); };
    const Point a = any(), b = any(), c = any();
    ASSERT_EQ(Orientation(a, b, c), SlowOrientation(a, b, c));
  }
}

/// Four points within a few ulps of one circle, or anywhere.
std::array<Point, 4> NearCircle(Rng& rng) {
  const double scale = std::ldexp(1, rng.UniformInt(-100, 100));
  const Point centre = RandomPoint(rng, scale);
  const double radius = rng.Uniform(0.1, 2) * scale;
  const bool anywhere = rng.UniformInt(0, 3) == 0;
  std::array<Point, 4> points;
  for (Point& p : points) {
    const double angle = rng.Uniform(0, 2 * std::numbers::pi);
    p = anywhere ? RandomPoint(rng, scale) : Nudged(rng, centre + radius * Point{std::cos(angle), std::sin(angle)});
  }
  return points;
}

TEST(Predicates, InCircleIsExactAndAlternates) {
  const std::int64_t count = ScaledTestCount(10000);
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const auto [a, b, c, d] = NearCircle(rng);
    const int inside = InCircle(a, b, c, d);
    ASSERT_EQ(inside, SlowInCircle(a, b, c, d));
    ASSERT_EQ(inside, internal::ExactInCircle(a, b, c, d));
    ASSERT_EQ(inside, InCircle(b, c, a, d));
    ASSERT_EQ(inside, -InCircle(b, a, c, d));
    ASSERT_EQ(inside, -InCircle(a, b, d, c));
    ASSERT_EQ(InCircle(a, b, c, a), 0);
  }
}

TEST(Predicates, InCircleIsExactOnRasters) {
  const std::int64_t count = ScaledTestCount(10000);
  int zeros = 0;
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    constexpr std::array<double, 3> kResolutions{0.05, 1, 0.1};
    const double resolution = kResolutions[static_cast<std::size_t>(rng.UniformInt(0, 2))];
    const Point origin = rng.UniformInt(0, 1) == 0 ? Point{0, 0} : Point{rng.Uniform(-50, 50), rng.Uniform(-1e6, 1e6)};
    const auto any = [&] {
      return origin + resolution * Point{1.0 * rng.UniformInt(0, 3), 1.0 * rng.UniformInt(0, 3)};
    };
    const Point a = any(), b = any(), c = any(), d = any();
    const int inside = SlowInCircle(a, b, c, d);
    ASSERT_EQ(InCircle(a, b, c, d), inside);
    ASSERT_EQ(internal::ExactInCircle(a, b, c, d), inside);
    zeros += inside == 0 ? 1 : 0;
  }
  EXPECT_GT(zeros, count / 20);
}

TEST(Predicates, InCircleOfVeryDifferentMagnitudes) {
  const std::int64_t count = ScaledTestCount(3000);
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const int spread = rng.UniformInt(0, 1) == 0 ? 10 : 100;  // Around what still fits into 62 bits, and far beyond.
    const auto any = [&] { return RandomPoint(rng, std::ldexp(1, rng.UniformInt(-spread, spread))); };
    const Point a = any(), b = any(), c = any(), d = any();
    ASSERT_EQ(internal::ExactInCircle(a, b, c, d), SlowInCircle(a, b, c, d));
    ASSERT_EQ(internal::ExactInCircle(a, b, c, {0, 0}), SlowInCircle(a, b, c, {0, 0}));
  }
}

TEST(Predicates, InCircleOfTheLargestMantissas) {
  // The determinants that need the most bits.
  const double most = std::nextafter(2.0, 0), less = std::nextafter(most, 0);
  for (const double x : {-most, -less, less, most}) {
    for (const double y : {-most, -less, less, most}) {
      const Point a{-most, -most}, b{most, -most}, c{most, most}, d{x, y};
      EXPECT_EQ(internal::ExactInCircle(a, b, c, d), SlowInCircle(a, b, c, d)) << x << " " << y;
      EXPECT_EQ(internal::ExactInCircle(a, d, b, c), SlowInCircle(a, d, b, c)) << x << " " << y;
    }
  }
}

TEST(Predicates, InCircleOfASquare) {
  const Point a{0, 0}, b{1, 0}, c{1, 1};
  EXPECT_EQ(InCircle(a, b, c, {0, 1}), 0);
  EXPECT_EQ(InCircle(a, b, c, {0.5, 0.5}), 1);
  EXPECT_EQ(InCircle(a, b, c, {0, std::nextafter(1.0, 2.0)}), -1);
  EXPECT_EQ(InCircle(a, b, c, {0, std::nextafter(1.0, 0.0)}), 1);
}

TEST(Predicates, OnSegmentHasItsEnds) {
  const Point a{0, 0}, b{4, 2};
  EXPECT_TRUE(OnSegment(a, b, a));
  EXPECT_TRUE(OnSegment(a, b, b));
  EXPECT_TRUE(OnSegment(a, b, {2, 1}));
  EXPECT_FALSE(OnSegment(a, b, {6, 3}));
  EXPECT_FALSE(OnSegment(a, b, {2, std::nextafter(1.0, 2.0)}));
}

TEST(Predicates, CrossProperlyNeedsAPointInsideBoth) {
  EXPECT_TRUE(CrossProperly({0, 0}, {2, 2}, {0, 2}, {2, 0}));
  EXPECT_FALSE(CrossProperly({0, 0}, {2, 2}, {1, 1}, {2, 0})) << "touches";
  EXPECT_FALSE(CrossProperly({0, 0}, {2, 2}, {1, 1}, {3, 3})) << "overlaps";
  EXPECT_FALSE(CrossProperly({0, 0}, {1, 1}, {0, 4}, {4, 0})) << "ends before";
}

/// Where the line through c and d crosses that through a and b, as a share of ab.
Rational ShareOfCrossing(Point a, Point b, Point c, Point d) {
  const auto area = [&](Point p) -> Rational {
    return (Rational(d.x) - Rational(c.x)) * (Rational(p.y) - Rational(c.y)) -
           (Rational(d.y) - Rational(c.y)) * (Rational(p.x) - Rational(c.x));
  };
  const Rational at_a = area(a);
  return at_a / (at_a - area(b));
}

TEST(Predicates, CompareCrossingsAgreesWithRationals) {
  Rng rng(20191);
  int ties = 0;
  const std::int64_t count = ScaledTestCount(20000);
  for (std::int64_t trial = 0; trial < count; ++trial) {
    // Small integers meet in one point often; so do the same numbers with a digit, up to rounding.
    const double scale = trial % 2 == 0 ? 1 : 0.1;
    Point p[6];
    for (Point& q : p) q = {scale * rng.UniformInt(-3, 3), scale * rng.UniformInt(-3, 3)};
    const auto [a, b, c, d, e, f] = p;
    if (Orientation(c, d, a) * Orientation(c, d, b) >= 0 || Orientation(e, f, a) * Orientation(e, f, b) >= 0) continue;
    const Rational difference = ShareOfCrossing(a, b, c, d) - ShareOfCrossing(a, b, e, f);
    ties += difference == 0;
    ASSERT_EQ(CompareCrossings(a, b, c, d, e, f), difference.sign()) << "trial " << trial;
    ASSERT_EQ(CompareCrossings(a, b, d, c, f, e), difference.sign()) << "trial " << trial;
    ASSERT_EQ(CompareCrossings(b, a, c, d, e, f), -difference.sign()) << "trial " << trial;
    ASSERT_EQ(CompareCrossings(a, b, e, f, c, d), -difference.sign()) << "trial " << trial;
  }
  EXPECT_GE(ties, count / 1000);
}

}  // namespace
}  // namespace tautline
