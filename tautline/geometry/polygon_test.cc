#include "tautline/geometry/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/predicates.h"
#include "tautline/geometry/random_rings.h"

namespace tautline {
namespace {

/// An angular C that opens to the right; its centroid lies in the opening.
const Ring kBracket{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {4, 3}, {4, 4}, {0, 4}};

Ring Rotated(Ring ring, std::size_t by) {
  std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(by % ring.size()), ring.end());
  return ring;
}

/// The winding number as the sum of the angles under which the edges are seen.
int SlowWinding(const Ring& ring, Point p) {
  double turn = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point u = ring[i] - p, v = ring[(i + 1) % ring.size()] - p;
    turn += std::atan2(Cross(u, v), Dot(u, v));
  }
  return static_cast<int>(std::lround(turn / (2 * std::numbers::pi)));
}

TEST(Polygon, BoxGrowsFromEmpty) {
  Box box;
  EXPECT_TRUE(box.empty());
  box.Add({2, 3});
  EXPECT_FALSE(box.empty());
  EXPECT_EQ(box.size(), (Point{0, 0}));
  box.Add({-2, 5});
  EXPECT_EQ(box.centre(), (Point{0, 4}));
  EXPECT_EQ(BoundingBox(kBracket).high, (Point{4, 4}));
}

TEST(Polygon, AreaAndLength) {
  EXPECT_EQ(SignedArea(kBracket), 10);
  EXPECT_EQ(SignedArea(Ring(kBracket.rbegin(), kBracket.rend())), -10);
  EXPECT_EQ(SignedArea(Ring{}), 0);
  EXPECT_EQ(Length(kBracket), 18);
  EXPECT_EQ(Length(Polyline{{1, 1}}), 0);
}

TEST(Polygon, AreaKeepsItsDigitsFarAway) {
  Ring ring;
  for (const Point p : kBracket) ring.push_back(Point{1e9, -1e9} + p);
  EXPECT_EQ(SignedArea(ring), 10);
}

TEST(Polygon, WindingNumberOfRandomCurves) {
  const std::int64_t count = ScaledTestCount(3000);
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    // Lattice curves that cross themselves and pass through the heights of other vertices.
    const auto lattice_point = [&rng] { return Point{1.0 * rng.UniformInt(0, 6), 1.0 * rng.UniformInt(0, 6)}; };
    Ring ring;
    for (int i = rng.UniformInt(1, 9); i >= 0; --i) ring.push_back(lattice_point());
    const Point p = 0.5 * (lattice_point() + lattice_point());
    const Winding winding = WindingNumber(ring, p);
    bool on_boundary = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      on_boundary = on_boundary || OnSegment(ring[i], ring[(i + 1) % ring.size()], p);
    }
    ASSERT_EQ(winding.on_boundary, on_boundary);
    if (!on_boundary) {
      ASSERT_EQ(winding.number, SlowWinding(ring, p));
      const Winding mirrored = WindingNumber(Ring(ring.rbegin(), ring.rend()), p);
      ASSERT_EQ(mirrored.number, -winding.number);
    }
    ASSERT_EQ(ContainsPoint(ring, p), on_boundary || winding.number != 0);
  }
}

TEST(Polygon, StrictlyInsideLeavesOutBoundariesAndHoles) {
  const PolygonWithHoles polygon{Rectangle({0, 0}, {4, 4}), {Rectangle({1, 1}, {2, 2})}};
  EXPECT_TRUE(StrictlyInside(polygon, {3, 3}));
  EXPECT_FALSE(StrictlyInside(polygon, {0, 3}));
  EXPECT_FALSE(StrictlyInside(polygon, {1.5, 1.5}));
  EXPECT_FALSE(StrictlyInside(polygon, {1, 1.5}));
  EXPECT_FALSE(StrictlyInside(polygon, {5, 1.5}));
}

TEST(Polygon, InteriorPointIsTheCentroidWhenThatIsInside) {
  EXPECT_EQ(InteriorPoint({Rectangle({0, 0}, {4, 2}), {}}), (Point{2, 1}));
}

TEST(Polygon, InteriorPointOfConcaveAndHollowPolygons) {
  const PolygonWithHoles bracket{kBracket, {}};
  EXPECT_TRUE(StrictlyInside(bracket, InteriorPoint(bracket)));
  const PolygonWithHoles frame{Rectangle({0, 0}, {4, 4}), {Rectangle({0.5, 0.5}, {3.5, 3.5})}};
  EXPECT_TRUE(StrictlyInside(frame, InteriorPoint(frame)));
}

TEST(Polygon, InteriorPointOfRandomPolygons) {
  const std::int64_t count = ScaledTestCount(3000);
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const Box box = RandomBox(rng);
    for (const PolygonWithHoles& polygon : RandomPolygons(rng, box)) {
      ASSERT_TRUE(StrictlyInside(polygon, InteriorPoint(polygon)));
      PolygonWithHoles reversed = polygon;
      std::reverse(reversed.outer.begin(), reversed.outer.end());
      ASSERT_TRUE(StrictlyInside(reversed, InteriorPoint(reversed)));
    }
  }
}

TEST(Polygon, NearestOnSegment) {
  EXPECT_EQ(NearestOnSegment({1, 3}, {0, 0}, {4, 0}), (Point{1, 0}));
  EXPECT_EQ(NearestOnSegment({-1, 3}, {0, 0}, {4, 0}), (Point{0, 0}));
  EXPECT_EQ(NearestOnSegment({9, 3}, {0, 0}, {4, 0}), (Point{4, 0}));
  EXPECT_EQ(NearestOnSegment({9, 3}, {2, 2}, {2, 2}), (Point{2, 2}));
  EXPECT_EQ(DistanceToSegment({1, 3}, {0, 0}, {4, 0}), 3);
  EXPECT_EQ(DistanceToSegment({7, 4}, {0, 0}, {4, 0}), 5);
}

TEST(Polygon, DropCollinearKeepsCornersOnly) {
  const Ring square = Rectangle({0, 0}, {2, 2});
  const Ring busy{{0, 0}, {1, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}, {0, 0.5}};
  for (std::size_t by = 0; by < busy.size(); ++by) {
    const Ring clean = DropCollinear(Rotated(busy, by));
    const auto start = std::find(clean.begin(), clean.end(), square[0]);
    ASSERT_NE(start, clean.end());
    EXPECT_EQ(Rotated(clean, static_cast<std::size_t>(start - clean.begin())), square);
  }
}

TEST(Polygon, DropStraightKeepsSpikes) {
  // A square with a spike from (2, 0) to (7, 0), with superfluous vertices on sides and spike.
  const Ring busy{{0, 0}, {2, 0}, {5, 0}, {7, 0}, {7, 0}, {4, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}};
  for (std::size_t by = 0; by < busy.size(); ++by) {
    SCOPED_TRACE(by);
    Ring corners = DropStraight(Rotated(busy, by));
    std::rotate(corners.begin(), std::find(corners.begin(), corners.end(), busy[0]), corners.end());
    EXPECT_EQ(corners, (Ring{{0, 0}, {7, 0}, {2, 0}, {2, 2}, {0, 2}}));
  }
  EXPECT_EQ(DropStraight(Ring{{0, 0}, {2, 2}, {1, 1}}), (Ring{{0, 0}, {2, 2}}));
  EXPECT_EQ(DropStraight(Ring{{1, 1}, {1, 1}}), (Ring{{1, 1}}));
  EXPECT_TRUE(DropStraight(Ring{}).empty());
}

TEST(Polygon, DropCollinearDropsSpikesWhereverTheRingStarts) {
  const Ring spiked{{0, 0}, {2, 0}, {5, 0}, {7, 0}, {2, 0}, {2, 2}, {0, 2}};
  for (std::size_t by = 0; by < spiked.size(); ++by) {
    SCOPED_TRACE(by);
    const Ring clean = DropCollinear(Rotated(spiked, by));
    EXPECT_EQ(clean.size(), 4u);
    EXPECT_EQ(SignedArea(clean), 4);
  }
}

TEST(Polygon, DropCollinearOfARingWithoutATurn) {
  EXPECT_TRUE(DropCollinear(Ring{}).empty());
  EXPECT_EQ(DropCollinear(Ring{{1, 1}, {1, 1}, {1, 1}}), (Ring{{1, 1}}));
  const Ring line{{0, 0}, {1, 1}, {2, 2}};
  for (std::size_t by = 0; by < 3; ++by) EXPECT_LE(DropCollinear(Rotated(line, by)).size(), 2u);
}

TEST(Polygon, DropCollinearOfRandomLatticeCurves) {
  const std::int64_t count = ScaledTestCount(10000);
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    Ring ring;
    for (int i = rng.UniformInt(2, 12); i > 0; --i) {
      ring.push_back({1.0 * rng.UniformInt(0, 3), 1.0 * rng.UniformInt(0, 3)});
    }
    const Ring clean = DropCollinear(ring);
    ASSERT_EQ(SignedArea(clean), SignedArea(ring));
    ASSERT_EQ(DropCollinear(clean), clean);
    for (std::size_t i = 0; clean.size() >= 3 && i < clean.size(); ++i) {
      const Point next = clean[(i + 1) % clean.size()], second = clean[(i + 2) % clean.size()];
      ASSERT_NE(Orientation(clean[i], next, second), 0);
    }
  }
}

}  // namespace
}  // namespace tautline
