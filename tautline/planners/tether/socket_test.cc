#include "tautline/homotopy/socket.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/predicates.h"
#include "tautline/homotopy/random_scene.h"
#include "tautline/homotopy/ring_ground.h"
#include "tautline/planners/tether/tether_planner.h"

namespace tautline {
namespace {

template <class Visit>
void ForEachEdge(const FreeSpace& space, Visit visit) {
  for (const Ring& ring : RingsOf(space)) {
    for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
  }
}

/// Whether blocked ground touches where the segment passes: rings say nothing about the way through there.
bool PassesMeeting(const FreeSpace& space, Point a, Point b) {
  bool passes = false;
  ForEachEdge(space, [&](Point vertex, Point) {
    if (passes || DistanceToSegment(vertex, a, b) > 1e-9) return;
    int edges = 0;
    ForEachEdge(space, [&](Point p, Point q) { edges += OnSegment(p, q, vertex) ? 1 : 0; });
    passes = edges > 2;
  });
  return passes;
}

/// The length of the shortest straight way out, by the definition: the nearest point in sight of an edge is its nearest
/// point of all, an end, or where a line of sight grazes a vertex. Infinite when there is none; nothing when rings do
/// not tell. O(n^3).
std::optional<double> ShortestWayOut(const TetherPlanner& planner, Point base) {
  const FreeSpace &grown = planner.space().free_space(), &ungrown = planner.ungrown_space();
  const RingGround ground(ungrown);
  std::vector<Point> exits;
  ForEachEdge(grown, [&](Point a, Point b) {
    exits.push_back(NearestOnSegment(base, a, b));
    exits.push_back(a);
    ForEachEdge(ungrown, [&](Point vertex, Point) {
      const double side_a = Cross(vertex - base, a - base), side_b = Cross(vertex - base, b - base);
      if ((side_a < 0) == (side_b < 0) || side_a == side_b) return;
      const Point meet = Lerp(a, b, side_a / (side_a - side_b));
      if (Dot(meet - base, vertex - base) > 0) exits.push_back(meet);
    });
  });
  std::sort(exits.begin(), exits.end(), [base](Point p, Point q) { return Distance(base, p) < Distance(base, q); });
  for (const Point exit : exits) {
    // Lines that graze are rounded.
    if (!ground.HoldsSegment(base, exit, 1e-9)) continue;
    if (PassesMeeting(ungrown, base, exit)) return std::nullopt;
    return Distance(base, exit);
  }
  return std::numeric_limits<double>::infinity();
}

/// A point of the free ground that growth has taken, sometimes on a wall or at a corner of one.
std::optional<Point> RandomSocketBase(Rng& rng, const TetherPlanner& planner) {
  const FreeSpace& ungrown = planner.ungrown_space();
  for (int attempt = 0; attempt < 100; ++attempt) {
    Point base = RandomPoint(rng, ungrown.box);
    const std::vector<Ring> rings = RingsOf(ungrown);
    const Ring& ring = rings[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(rings.size()) - 1))];
    const auto vertex = static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(ring.size()) - 1));
    const int kind = rng.UniformInt(0, 3);
    if (kind == 0) base = ring[vertex];
    if (kind == 1) base = Lerp(ring[vertex], ring[(vertex + 1) % ring.size()], rng.Uniform(0, 1));
    if (!planner.space().Locate(base) && ComponentOf(ungrown, base, 1e-12)) return base;
  }
  return std::nullopt;
}

class FindSocketRandom : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Families, FindSocketRandom, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "Lattice" : "Separated"; });

TEST_P(FindSocketRandom, IsTheShortestWayOut) {
  int out = 0, none = 0;
  const std::int64_t count = ScaledTestCount(400);
  for (std::int64_t seed = 0; seed < count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    RandomScene scene = MakeRandomScene(rng, GetParam());
    scene.world.clearance = rng.Uniform(0.05, 1.5);
    const auto planner = TetherPlanner::Prepare(scene.world);
    if (!planner) continue;
    const auto base = RandomSocketBase(rng, *planner);
    if (!base) continue;
    const auto socket = FindSocket(planner->space(), planner->ungrown(), *base);
    const auto expected = ShortestWayOut(*planner, *base);
    if (!expected) continue;
    ASSERT_EQ(socket.has_value(), std::isfinite(*expected)) << base->x << " " << base->y << " " << *expected;
    (socket ? out : none) += 1;
    if (!socket) continue;
    ASSERT_NEAR(socket->stub_length, *expected, 1e-6) << base->x << " " << base->y;
    ASSERT_GT(socket->stub_length, 0);
    ASSERT_TRUE(planner->space().Locate(socket->exit.point));
  }
  EXPECT_GT(out, count / 4);
}

/// The nearest point of the only edge in sight is hidden, another one of it is not.
TEST(FindSocket, LooksPastABlind) {
  World world;
  world.outline = {{0, 0}, {20, 0}, {20, 10}, {0, 10}};
  // The base stands in front of the lower wall, and a blind hangs just above it.
  world.obstacles = {{.name = "blind", .polygon = PolygonWithHoles{{{7, 0.6}, {12, 0.6}, {12, 0.7}, {7, 0.7}}}}};
  world.clearance = 1;
  const auto planner = TetherPlanner::Prepare(world).value();
  const auto socket = FindSocket(planner.space(), planner.ungrown(), {8, 0.5});
  ASSERT_TRUE(socket);
  EXPECT_NEAR(socket->stub_length, ShortestWayOut(planner, {8, 0.5}).value(), 1e-9);
}

}  // namespace
}  // namespace tautline
