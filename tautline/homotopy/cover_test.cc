#include "tautline/homotopy/cover.h"

#include <gtest/gtest.h>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/homotopy/random_scene.h"
#include "tautline/homotopy/sketched_scene.h"
#include "tautline/homotopy/taut.h"

namespace tautline {
namespace {

TriangleId T(int id) { return TriangleId(static_cast<std::int32_t>(id)); }

Sleeve SleeveOf(std::initializer_list<int> triangles) {
  Sleeve sleeve(T(*triangles.begin()));
  for (const int id : triangles) sleeve.Step(T(id));
  return sleeve;
}

TEST(Sleeve, CancelsStepsThatAreUndone) {
  EXPECT_EQ(SleeveOf({1, 2, 3, 2}), SleeveOf({1, 2}));
  EXPECT_EQ(SleeveOf({1, 2, 3, 2, 1}), SleeveOf({1}));
  EXPECT_EQ(SleeveOf({1, 2, 3, 4, 3, 2, 5}), SleeveOf({1, 2, 5}));
  EXPECT_EQ(SleeveOf({1, 1, 1}), SleeveOf({1}));
  EXPECT_NE(SleeveOf({1, 2, 3, 1}), SleeveOf({1})) << "around a hole";
}

TEST(Sleeve, ReversedTwiceIsItself) {
  const Sleeve sleeve = SleeveOf({1, 2, 5, 1});
  EXPECT_EQ(sleeve.Reversed(), SleeveOf({1, 5, 2, 1}));
  EXPECT_EQ(sleeve.Reversed().Reversed(), sleeve);
}

/// A mesh with a walk in it.
struct Ground {
  explicit Ground(const std::vector<std::string_view>& rows) : mesh(SpaceOf(Sketch(rows))) {}

  Walk At(Point p) const { return Walk(mesh.Locate(p, 0).value()); }

  FreeMesh mesh;
};

const std::vector<std::string_view> kOneBlock = {"....",  //
                                                 ".aa.",  //
                                                 ".aa.",  //
                                                 "...."};

const std::vector<std::string_view> kTouchingBlocks = {"....",  //
                                                       "..b.",  //
                                                       ".a..",  //
                                                       "...."};

TEST(WalkStraight, PassesAlongSidesAndThroughVertices) {
  const Ground ground(kOneBlock);
  for (const auto& [from, to] : {std::pair<Point, Point>{{0, 1}, {4, 1}},  // along the lower side, and beyond both ends
                                 {{1, 0}, {1, 4}},                         // along the left side
                                 {{1, 1}, {3, 1}},                         // from corner to corner
                                 {{1.5, 1}, {2.5, 1}},                     // on a side
                                 {{0, 2}, {2, 0}},                         // grazing a corner
                                 {{0, 4}, {0, 0}}}) {                      // along the wall
    Walk walk = ground.At(from);
    EXPECT_FALSE(WalkStraight(ground.mesh, to, walk));
    EXPECT_EQ(walk.at, to);
    EXPECT_FALSE(WalkStraight(ground.mesh, from, walk));
    EXPECT_EQ(PullTaut(ground.mesh, walk).points.size(), 1U) << "there and back is nothing";
  }
}

TEST(WalkStraight, StopsWhereItLeavesTheFreeSpace) {
  const Ground ground(kOneBlock);
  Walk walk = ground.At({0, 2});
  const auto blocked = WalkStraight(ground.mesh, {4, 2}, walk);
  ASSERT_TRUE(blocked);
  EXPECT_NEAR(Distance(*blocked, {1, 2}), 0, 1e-12);
  walk = ground.At({0, 0});
  const auto at_corner = WalkStraight(ground.mesh, {4, 4}, walk);
  ASSERT_TRUE(at_corner);
  EXPECT_EQ(*at_corner, (Point{1, 1}));
  walk = ground.At({0.5, 0.25});
  const auto at_wall = WalkStraight(ground.mesh, {0.5, -3}, walk);
  ASSERT_TRUE(at_wall);
  EXPECT_NEAR(Distance(*at_wall, {0.5, 0}), 0, 1e-12);
}

TEST(WalkStraight, DoesNotSlipBetweenObstaclesThatTouch) {
  const Ground ground(kTouchingBlocks);
  for (const auto& [from, to] :
       {std::pair<Point, Point>{{1, 3}, {3, 1}}, {{1.5, 2.25}, {2.5, 1.75}}, {{1, 2}, {3, 2}}}) {
    Walk walk = ground.At(from);
    const auto blocked = WalkStraight(ground.mesh, to, walk);
    ASSERT_TRUE(blocked);
    EXPECT_EQ(*blocked, (Point{2, 2}));
  }
  Walk walk = ground.At({1, 3});
  EXPECT_FALSE(WalkStraight(ground.mesh, {2, 2}, walk)) << "up to the touching point";
  EXPECT_FALSE(WalkStraight(ground.mesh, {1, 2.5}, walk)) << "and back on the same side";
}

TEST(WalkNearly, LeadsAroundACornerThatItCutsByLessThanTheTolerance) {
  const Ground ground(kOneBlock);
  const Point from{0, 2 + 1e-7}, to{2, 1e-7};
  Walk walk = ground.At(from);
  EXPECT_TRUE(WalkNearly(ground.mesh, to, 1e-8, walk));
  walk = ground.At(from);
  ASSERT_FALSE(WalkNearly(ground.mesh, to, 1e-6, walk));
  const TautCurve taut = PullTaut(ground.mesh, walk);
  ASSERT_EQ(taut.points.size(), 3U);
  EXPECT_EQ(taut.points[1].point, (Point{1, 1}));
}

TEST(WalkNearly, FollowsASideThatItCutsByLessThanTheTolerance) {
  const Ground ground(kOneBlock);
  Walk walk = ground.At({0, 1 + 1e-8});
  ASSERT_FALSE(WalkNearly(ground.mesh, {4, 1 + 1e-8}, 1e-6, walk));
  EXPECT_NEAR(PullTaut(ground.mesh, walk).length, 4, 1e-12);
}

class CoverRandom : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Families, CoverRandom, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "Lattice" : "Separated"; });

TEST_P(CoverRandom, StraightWalksArriveExactlyWhereThereIsSight) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(300); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng, GetParam());
    const FreeMesh mesh(scene.space);
    const Point from = RandomFreePoint(rng, scene);
    const BruteSight sight(scene.rings, std::vector{from, RandomFreePoint(rng, scene), RandomFreePoint(rng, scene)});
    const std::size_t start = sight.NodesAt(from).at(0);
    for (std::size_t node = 0; node < sight.nodes().size(); ++node) {
      const Point to = sight.nodes()[node].point;
      Walk walk(mesh.Locate(from, 0).value());
      const bool arrived = !WalkStraight(mesh, to, walk);
      // A point where obstacles touch is reached when any of its sectors is seen.
      bool seen = to == from;
      for (const std::size_t there : sight.NodesAt(to)) seen = seen || sight.Sees(start, there);
      ASSERT_EQ(arrived, seen) << from.x << ' ' << from.y << " -> " << to.x << ' ' << to.y;
    }
  }
}

TEST_P(CoverRandom, AWalkAndItsReverseAreNothing) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(300); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng, GetParam());
    const FreeMesh mesh(scene.space);
    const std::vector<Point> points{RandomFreePoint(rng, scene), RandomFreePoint(rng, scene)};
    const ClassOracle oracle(scene.rings, scene.representatives, points);
    const auto laid =
        RandomWalk(rng, oracle, oracle.sight().NodesAt(points[0])[0], oracle.sight().NodesAt(points[1])[0]);
    if (!laid) continue;
    Walk walk(mesh.Locate(points[0], 0).value());
    for (const Point p : *laid) ASSERT_FALSE(WalkStraight(mesh, p, walk));
    const Walk out = walk;
    for (auto p = laid->rbegin(); p != laid->rend(); ++p) ASSERT_FALSE(WalkStraight(mesh, *p, walk));
    ASSERT_EQ(PullTaut(mesh, walk).points.size(), 1U);
    for (const Point p : *laid) ASSERT_FALSE(WalkStraight(mesh, p, walk));
    ASSERT_EQ(PullTaut(mesh, walk).length, PullTaut(mesh, out).length);
  }
}

}  // namespace
}  // namespace tautline
