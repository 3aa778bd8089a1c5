#include "tautline/planners/contact_free/contact_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

Ring Rectangle(double x, double y, double w, double h) { return {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}; }

World RandomWorld(Rng& rng) {
  World world{.outline = Rectangle(0, 0, 12, 9)};
  const int count = rng.UniformInt(0, 9);
  for (int i = 0; i < count; ++i) {
    const Point at{rng.Uniform(-1, 12), rng.Uniform(-1, 9)};
    Ring ring = Rectangle(at.x, at.y, rng.Uniform(0.2, 3), rng.Uniform(0.2, 3));
    if (rng.UniformInt(0, 2) == 0) ring.pop_back();
    if (rng.UniformInt(0, 4) == 0) {
      for (Point& p : ring) p = {std::round(p.x), std::round(p.y)};
      if (std::abs(SignedArea(ring)) < 0.5) continue;
    }
    world.obstacles.push_back({.polygon = PolygonWithHoles{ring, {}}});
  }
  return world;
}

/// Every edge and every winding number.
struct SlowMap {
  std::vector<Ring> outer, holes;

  explicit SlowMap(const FreeSpace& space) {
    for (const FreeComponent& component : space.components) {
      outer.push_back(component.outer.points);
      for (const BoundaryRing& hole : component.holes) holes.push_back(hole.points);
    }
  }
  template <class Visit>
  void ForEachEdge(Visit visit) const {
    for (const auto* rings : {&outer, &holes}) {
      for (const Ring& ring : *rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
      }
    }
  }
  bool IsBlocked(Point p) const {
    bool inside = false, edge = false;
    ForEachEdge([&](Point a, Point b) { edge = edge || OnSegment(a, b, p); });
    for (const Ring& ring : outer) inside = inside || WindingNumber(ring, p).number != 0;
    for (const Ring& ring : holes) inside = inside && WindingNumber(ring, p).number == 0;
    return edge || !inside;
  }
  double DistanceFrom(Point p) const {
    double best = 1e300;
    ForEachEdge([&](Point a, Point b) { best = std::min(best, DistanceToSegment(p, a, b)); });
    return IsBlocked(p) ? 0 : best;
  }
  bool SegmentTouches(Point a, Point b) const {
    bool touches = IsBlocked(a) || IsBlocked(b);
    ForEachEdge([&](Point c, Point d) {
      touches = touches || CrossProperly(a, b, c, d) || OnSegment(a, b, c) || OnSegment(a, b, d);
    });
    return touches;
  }
};

TEST(SegmentMeetsBox, TouchingCounts) {
  const Box box{{0, 0}, {2, 1}};
  EXPECT_TRUE(SegmentMeetsBox({-1, 0.5}, {3, 0.5}, box));
  EXPECT_TRUE(SegmentMeetsBox({0.5, 0.5}, {0.6, 0.5}, box));  // inside
  EXPECT_TRUE(SegmentMeetsBox({-1, 1}, {3, 1}, box));         // along a side
  EXPECT_TRUE(SegmentMeetsBox({-1, 0}, {1, 2}, box));         // through a corner
  EXPECT_FALSE(SegmentMeetsBox({-1, 0}, {1, 2.001}, box));
  EXPECT_FALSE(SegmentMeetsBox({-1, 1.001}, {3, 1.001}, box));
  EXPECT_FALSE(SegmentMeetsBox({-2, 0.5}, {-0.001, 0.5}, box));
  EXPECT_TRUE(SegmentMeetsBox({2, 1}, {2, 1}, box));
  EXPECT_FALSE(SegmentMeetsBox({2.001, 1}, {2.001, 1}, box));
}

TEST(ContactMapRandom, AgreesWithAllEdges) {
  const auto scenes = ScaledTestCount(200);
  int touching = 0, asked = 0;
  for (int seed = 1; seed <= scenes; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const auto space = BuildFreeSpace(RandomWorld(rng));
    if (!space) continue;
    const ContactMap map(*space, rng.Uniform(0.02, 0.4));
    const SlowMap slow(*space);
    for (int k = 0; k < 100; ++k, ++asked) {
      Point a{rng.Uniform(-0.5, 12.5), rng.Uniform(-0.5, 9.5)};
      if (k % 10 == 0) a = {std::round(a.x), std::round(a.y)};
      const Point b = a + Point{rng.Uniform(-1, 1), rng.Uniform(-1, 1)};
      const bool touches = slow.SegmentTouches(a, b);
      touching += touches ? 1 : 0;
      ASSERT_EQ(map.SegmentTouches(a, b), touches) << a.x << ' ' << a.y << ' ' << b.x << ' ' << b.y;
      ASSERT_EQ(map.IsBlocked(a), slow.IsBlocked(a));
      const double distance = slow.DistanceFrom(a);
      ASSERT_LE(map.ClearAround(a), distance);
      const double radius = rng.Uniform(0.01, 1);
      ASSERT_EQ(map.DiscTouches(a, radius), distance <= radius);
    }
  }
  EXPECT_GT(touching, asked / 10);
  EXPECT_LT(touching, asked - asked / 10);
}

TEST(ContactMap, AnswersFarFromObstaclesFromItsGrid) {
  const auto space = BuildFreeSpace(World{.outline = Rectangle(0, 0, 10, 10)});
  ASSERT_TRUE(space);
  const ContactMap map(*space, 0.1);
  EXPECT_GT(map.ClearAround({5, 5}), 4.8);
  EXPECT_EQ(map.ClearAround({-1, 5}), 0);
  EXPECT_FALSE(map.DiscTouches({5, 5}, 4.9));
  EXPECT_TRUE(map.DiscTouches({5, 5}, 5));
}

}  // namespace
}  // namespace tautline
