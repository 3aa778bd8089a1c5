#include "tautline/geometry/grow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/random_rings.h"

namespace tautline {
namespace {

double DistanceToRing(const Ring& ring, Point p) {
  double least = 1e300;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    least = std::min(least, DistanceToSegment(p, ring[i], ring[(i + 1) % ring.size()]));
  }
  return least;
}

bool Covered(const Ring& ring, const std::vector<Ring>& pieces, Point p) {
  return ContainsPoint(ring, p) ||
         std::any_of(pieces.begin(), pieces.end(), [p](const Ring& piece) { return ContainsPoint(piece, p); });
}

/// A point about as far from the ring as the growth reaches.
Point NearReach(Rng& rng, const Ring& ring, double reach) {
  const auto i = static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(ring.size()) - 1));
  const Point on = Lerp(ring[i], ring[(i + 1) % ring.size()], rng.UniformInt(0, 1) == 0 ? 0 : rng.Uniform());
  const double angle = rng.Uniform(0, 7);
  return on + rng.Uniform(0, 1.5) * reach * Point{std::cos(angle), std::sin(angle)};
}

TEST(GrowthPieces, CoverTheRadiusAndLittleMore) {
  const std::int64_t count = ScaledTestCount(5000);
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const Box box{{0, 0}, {10, 10}};
    const Ring ring = rng.UniformInt(0, 1) == 0 ? RandomStar(rng, {5, 5}, 5) : RandomSliver(rng, box);
    const double radius = std::pow(10, rng.Uniform(-3, 1)), arc_error = std::pow(10, rng.Uniform(-4, 0));
    const std::vector<Ring> pieces = GrowthPieces(ring, radius, arc_error);
    for (const Ring& piece : pieces) ASSERT_GT(SignedArea(piece), -1e-12 * radius * (radius + 10));
    for (int k = 0; k < 40; ++k) {
      const Point p = NearReach(rng, ring, radius);
      const double distance = ContainsPoint(ring, p) ? 0 : DistanceToRing(ring, p);
      const bool covered = Covered(ring, pieces, p);
      ASSERT_TRUE(covered || distance > radius - 1e-11);
      ASSERT_TRUE(!covered || distance < radius * (1 + arc_error) + 1e-11);
    }
  }
}

TEST(GrowthPieces, OfASquare) {
  // Four rectangles and four fans; with an arc error of 1 the circumscribed corner is one point.
  const std::vector<Ring> pieces = GrowthPieces(Rectangle({0, 0}, {1, 1}), 1, 1);
  ASSERT_EQ(pieces.size(), 8u);
  EXPECT_EQ(pieces[0], (Ring{{0, 0}, {0, -1}, {1, -1}, {1, 0}}));
  EXPECT_EQ(pieces[1].size(), 4u);
  EXPECT_NEAR(Distance(pieces[1][2], {2, -1}), 0, 1e-15);
}

TEST(GrowthPieces, OfANeedleStayNearItsTip) {
  // The turn at the tip is half a turn but for less than rounding can tell.
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const Box box{{-1, -1}, {1, 1}};
    const Point a = RandomPoint(rng, box), b = RandomPoint(rng, box), c = Lerp(a, b, rng.Uniform());
    const Ring needle{a, b, {std::nextafter(c.x, rng.Uniform(-2, 2)), std::nextafter(c.y, rng.Uniform(-2, 2))}};
    for (const Ring& piece : GrowthPieces(needle, 0.1, 0.01)) {
      for (const Point p : piece) ASSERT_LT(DistanceToRing(needle, p), 0.102);
    }
  }
}

TEST(GrowthPieces, OfCollapsedRings) {
  const std::vector<Ring> disc = GrowthPieces(Ring{{2, 2}, {2, 2}, {2, 2}}, 1, 0.01);
  ASSERT_EQ(disc.size(), 1u);
  EXPECT_TRUE(ContainsPoint(disc[0], {2.7, 2.7}));
  const Ring segment{{0, 0}, {2, 0}, {1, 0}};
  const std::vector<Ring> capsule = GrowthPieces(segment, 1, 0.01);
  for (const Point p : {Point{-0.7, 0.7}, Point{-0.7, -0.7}, Point{1, 0.9}, Point{1, -0.9}, Point{2.9, 0}}) {
    EXPECT_TRUE(Covered({}, capsule, p)) << p.x << " " << p.y;
  }
  EXPECT_FALSE(Covered({}, capsule, {3.1, 0}));
  EXPECT_TRUE(GrowthPieces(Ring{}, 1, 0.01).empty());
}

TEST(GrowthPieces, OfASpike) {
  const Ring ring{{0, 0}, {2, 0}, {7, 0}, {2, 0}, {2, 2}, {0, 2}};
  const std::vector<Ring> pieces = GrowthPieces(ring, 1, 0.01);
  for (const Point p : {Point{5, 0.9}, Point{5, -0.9}, Point{7.9, 0}, Point{7.7, 0.7}}) {
    EXPECT_TRUE(Covered(ring, pieces, p)) << p.x << " " << p.y;
  }
  EXPECT_FALSE(Covered(ring, pieces, {8.1, 0}));
}

TEST(CircumscribedPolygon, HoldsTheDiscAndLittleMore) {
  Rng rng(1);
  for (int round = 0; round < 200; ++round) {
    const double radius = std::pow(10, rng.Uniform(-3, 3)), arc_error = std::pow(10, rng.Uniform(-5, 0));
    const Point centre{rng.Uniform(-9, 9), rng.Uniform(-9, 9)};
    const Ring polygon = CircumscribedPolygon(centre, radius, arc_error);
    EXPECT_GT(SignedArea(polygon), 3.14 * radius * radius);
    EXPECT_GE(DistanceToRing(polygon, centre), radius * (1 - 1e-12));
    for (const Point p : polygon) EXPECT_LE(Distance(centre, p), radius * (1 + arc_error) * (1 + 1e-9) + 1e-13);
  }
}

}  // namespace
}  // namespace tautline
