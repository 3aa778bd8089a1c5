#include "tautline/planners/cable_workspace/boundary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tautline/base/test_scale.h"
#include "tautline/homotopy/curve_faults.h"
#include "tautline/homotopy/sketched_scene.h"
#include "tautline/planners/cable_workspace/random_cables.h"

namespace tautline {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Where the winding number is not zero, square metres: slab by slab between the heights of the corners. No two edges
/// may cross.
double AreaBySlabs(const Ring& ring) {
  std::vector<double> heights;
  for (const Point p : ring) heights.push_back(p.y);
  std::sort(heights.begin(), heights.end());
  double area = 0;
  for (std::size_t h = 0; h + 1 < heights.size(); ++h) {
    const double y = 0.5 * (heights[h] + heights[h + 1]);
    std::vector<std::pair<double, int>> crossings;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[(i + 1) % ring.size()];
      if ((a.y < y) == (b.y < y)) continue;
      crossings.emplace_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x), a.y < y ? 1 : -1);
    }
    std::sort(crossings.begin(), crossings.end());
    int winding = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
      winding += crossings[i].second;
      if (winding != 0) area += (crossings[i + 1].first - crossings[i].first) * (heights[h + 1] - heights[h]);
    }
  }
  return area;
}

class BoundaryRandom : public testing::TestWithParam<bool> {
 protected:
  /// Calls visit(seed, workspace).
  template <class Visit>
  void ForEachWorkspace(std::int64_t count, Visit visit) {
    for (std::int64_t seed = 0; seed < ScaledTestCount(count); ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Rng rng(static_cast<std::uint64_t>(seed));
      const RandomCableWorkspace workspace = MakeRandomCableWorkspace(rng, GetParam());
      visit(rng, workspace);
    }
  }
};

INSTANTIATE_TEST_SUITE_P(Families, BoundaryRandom, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "Lattice" : "Separated"; });

TEST_P(BoundaryRandom, GoesOnceAroundAnAreaWithoutObstacles) {
  ForEachWorkspace(600, [](Rng&, const RandomCableWorkspace& workspace) {
    const WorkspaceBoundary& boundary = workspace.boundary;
    EXPECT_NEAR(AreaBySlabs(boundary.ring), boundary.area, 1e-9 * std::max(1.0, boundary.area));
    EXPECT_GT(boundary.area, 0);
    for (const Point p : workspace.cables.scene.representatives) {
      EXPECT_EQ(WindingNumber(boundary.ring, p).number, 0);
    }
  });
}

TEST_P(BoundaryRandom, HasSidesOfTheClassesOfTheCables) {
  ForEachWorkspace(600, [](Rng&, const RandomCableWorkspace& workspace) {
    const auto& [cables, boundary] = workspace;
    ClassOracle reader({}, cables.scene.representatives, {});
    double length = 0;
    Word product;
    for (std::size_t i = 0; i < boundary.sides.size(); ++i) {
      const TautPath& side = boundary.sides[i].path;
      const auto laid = LaidBetween(cables, i, NextAnchor(i, cables.anchors.size()));
      EXPECT_EQ(side.word, reader.words().ToWord(reader.AppendPolyline(0, laid)));
      EXPECT_EQ(side.points.front(), cables.anchors[i].exit.point);
      EXPECT_EQ(side.points.back(), cables.anchors[NextAnchor(i, cables.anchors.size())].exit.point);
      EXPECT_THAT(CurveFaults(cables.ground.space().free_space(), side), IsEmpty());
      length += side.length;
      product.Append(side.word);
    }
    EXPECT_TRUE(product.empty());
    EXPECT_NEAR(boundary.length, length, 1e-12 * length);
  });
}

std::vector<Word> WordsOf(const WorkspaceBoundary& boundary) {
  std::vector<Word> words;
  for (const BoundarySide& side : boundary.sides) words.push_back(side.path.word);
  return words;
}

TEST_P(BoundaryRandom, IsFoundByItsWords) {
  ForEachWorkspace(600, [](Rng&, const RandomCableWorkspace& workspace) {
    const auto& [cables, boundary] = workspace;
    const auto again = BoundaryOfWords(cables.ground, cables.anchors, WordsOf(boundary));
    ASSERT_TRUE(again) << again.error().explanation;
    EXPECT_EQ(again->ring, boundary.ring);
    EXPECT_EQ(again->area, boundary.area);
    for (std::size_t i = 0; i < boundary.sides.size(); ++i) {
      EXPECT_EQ(again->sides[i].walk.sleeve, boundary.sides[i].walk.sleeve);
    }
  });
}

TEST_P(BoundaryRandom, IsNotClosedWithAnotherWord) {
  ForEachWorkspace(300, [](Rng& rng, const RandomCableWorkspace& workspace) {
    const auto& [cables, boundary] = workspace;
    const auto islands = static_cast<int>(cables.scene.representatives.size());
    if (islands == 0) return;
    auto words = WordsOf(boundary);
    const auto changed = static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(words.size()) - 1));
    words[changed].Append({ObstacleId(rng.UniformInt(0, islands - 1)), rng.UniformInt(0, 1) == 0});
    const auto wrong = BoundaryOfWords(cables.ground, cables.anchors, words);
    ASSERT_FALSE(wrong);
    // An island of another free piece is not to be gone around.
    EXPECT_TRUE(wrong.error().obstruction == WorkspaceObstruction::kNotClosed ||
                wrong.error().obstruction == WorkspaceObstruction::kNoSuchClass);
  });
}

/// The boundary of the same cables where every point is mapped.
tl::expected<WorkspaceBoundary, BoundaryFault> MappedBoundary(const RandomCables& cables, World world,
                                                              Point (*map)(Point)) {
  world = MappedWorld(world, map);
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    // Islands are obstacles unless some of them touch.
    if (!cables.scene.lattice) world.obstacles[i].representative = map(cables.scene.representatives[i]);
  }
  const CableGround ground = CableGround::Prepare(world).value();
  std::vector<Point> points;
  for (const Point p : cables.points) points.push_back(map(p));
  auto laid = cables.laid;
  for (Polyline& cable : laid) {
    for (Point& p : cable) p = map(p);
  }
  return BoundaryOfCables(ground, PlaceAnchors(ground, points).value(), laid);
}

TEST_P(BoundaryRandom, HasFourTimesTheAreaAtTwiceTheSize) {
  ForEachWorkspace(300, [](Rng&, const RandomCableWorkspace& workspace) {
    const auto& [cables, boundary] = workspace;
    const auto twice = MappedBoundary(cables, cables.scene.world, [](Point p) { return 2 * p; });
    ASSERT_TRUE(twice) << twice.error().explanation;
    EXPECT_NEAR(twice->area, 4 * boundary.area, 1e-9 * boundary.area);
    EXPECT_NEAR(twice->length, 2 * boundary.length, 1e-9 * boundary.length);
    EXPECT_EQ(WordsOf(*twice), WordsOf(boundary));
  });
}

TEST_P(BoundaryRandom, IsTheSameInAMirror) {
  ForEachWorkspace(300, [](Rng&, const RandomCableWorkspace& workspace) {
    const auto& [cables, boundary] = workspace;
    const auto mirrored = MappedBoundary(cables, cables.scene.world, [](Point p) { return Point{16 - p.x, p.y}; });
    ASSERT_TRUE(mirrored) << mirrored.error().explanation;
    EXPECT_NEAR(mirrored->area, boundary.area, 1e-9 * boundary.area);
    EXPECT_NEAR(mirrored->length, boundary.length, 1e-9 * boundary.length);
    if (cables.scene.lattice) return;
    const std::vector<Point>& rays = cables.scene.representatives;
    const bool in_a_column = std::any_of(boundary.ring.begin(), boundary.ring.end(), [&rays](Point p) {
      return std::any_of(rays.begin(), rays.end(), [p](Point ray) { return ray.x == p.x; });
    });
    for (std::size_t i = 0; i < boundary.sides.size() && !in_a_column; ++i) {
      Word expected;
      for (const Letter letter : boundary.sides[i].path.word.letters()) {
        expected.Append({letter.obstacle, !letter.inverse});
      }
      EXPECT_EQ(mirrored->sides[i].path.word, expected);
    }
  });
}

/// Cables drawn into a sketch: anchors by their marks, and for each a polyline of marks from the robot.
struct SketchedCables {
  SketchedCables(const World& world, std::vector<Point> points)
      : ground(CableGround::Prepare(world).value()), anchors(PlaceAnchors(ground, points).value()) {}

  tl::expected<WorkspaceBoundary, BoundaryFault> Boundary(const std::vector<Polyline>& laid) const {
    return BoundaryOfCables(ground, anchors, laid);
  }

  CableGround ground;
  Anchors anchors;
};

/// A room of 8 m x 5 m with a block in the middle.
SketchedScene Block() {
  return Sketch({"........",  //
                 "........",  //
                 "..R.bb..",  //
                 "........",  //
                 "........"});
}

std::vector<Polyline> Straight(Point robot, std::span<const Point> anchors) {
  std::vector<Polyline> laid;
  for (const Point p : anchors) laid.push_back({robot, p});
  return laid;
}

TEST(Boundary, CutsOffTheBlock) {
  const auto scene = Block();
  const std::vector<Point> corners{{0, 0}, {8, 0}, {8, 5}, {0, 5}};
  const SketchedCables cables(scene.world, corners);
  const auto boundary = cables.Boundary({{scene['R'], {0, 0}},
                                         {scene['R'], {3, 1}, {8, 0}},
                                         {scene['R'], {3, 1}, {6.5, 1}, {8, 5}},
                                         {scene['R'], {0, 5}}});
  ASSERT_TRUE(boundary);
  EXPECT_EQ(boundary->ring, (Ring{{0, 0}, {8, 0}, {8, 5}, {6, 2}, {4, 2}, {0, 5}}));
  EXPECT_NEAR(boundary->area, 40 - 0.5 * (8 + 2) * 3, 1e-12);
  EXPECT_EQ(TouchedIslands(cables.ground, *boundary), (std::vector<ObstacleId>{ObstacleId(0)}));
}

TEST(Boundary, OfAnchorsInAnotherOrderCrossesItself) {
  const auto scene = Block();
  const std::vector<Point> points{{0, 0}, {8, 5}, {8, 0}, {0, 5}};
  const SketchedCables cables(scene.world, points);
  const Point below{3, 1};
  const auto boundary =
      cables.Boundary({{below, {0, 0}}, {below, {6.5, 1}, {8, 5}}, {below, {8, 0}}, {below, {2, 3}, {0, 5}}});
  ASSERT_FALSE(boundary);
  EXPECT_EQ(boundary.error().obstruction, WorkspaceObstruction::kCrossesItself);
  EXPECT_THAT(boundary.error().sides, ElementsAre(0, 2));
  EXPECT_EQ(boundary.error().curves.size(), 4U);
}

TEST(Boundary, OfAnchorsInTheOpenCrossesItselfAsWell) {
  const auto scene = Block();
  const std::vector<Point> points{{1, 1}, {3, 4}, {3, 1}, {1, 4}};
  const SketchedCables cables(scene.world, points);
  const auto boundary = cables.Boundary(Straight({2, 3}, points));
  ASSERT_FALSE(boundary);
  EXPECT_EQ(boundary.error().obstruction, WorkspaceObstruction::kCrossesItself);
  EXPECT_THAT(boundary.error().sides, ElementsAre(0, 2));
  const std::vector<Point> in_order{{1, 1}, {3, 1}, {3, 4}, {1, 4}};
  EXPECT_NEAR(SketchedCables(scene.world, in_order).Boundary(Straight({2, 3}, in_order))->area, 6, 1e-12);
}

// The diagonal may be an edge of the triangulation, or cross one.
TEST(Boundary, OfAnAnchorInTheOpenMayTouchItThere) {
  for (const double up : {1.0, -1.0}) {
    const World world{
        .outline = {{0, 0}, {15, 0}, {15, 15 * up}, {0, 15 * up}}, .obstacles = {}, .map = {}, .cells = {}};
    const std::vector<Point> points{{0, 0}, {15, 15 * up}, {0, 3 * up}, {4, 4 * up}};
    const auto boundary = SketchedCables(world, points).Boundary(Straight({1, 2 * up}, points));
    ASSERT_TRUE(boundary) << boundary.error().explanation;
    EXPECT_NEAR(boundary->area, 16.5, 1e-9);
  }
}

TEST(Boundary, OfAnchorsInALineHoldsNothing) {
  const auto scene = Block();
  const std::vector<Point> points{{1, 0}, {3, 0}, {7, 0}};
  const SketchedCables cables(scene.world, points);
  const auto boundary = cables.Boundary(Straight({2, 1}, points));
  ASSERT_FALSE(boundary);
  EXPECT_EQ(boundary.error().obstruction, WorkspaceObstruction::kNoArea);
}

TEST(Boundary, NeedsCablesInTheFreeGround) {
  const auto scene = Block();
  const std::vector<Point> corners{{0, 0}, {8, 0}, {8, 5}, {0, 5}};
  const SketchedCables cables(scene.world, corners);
  const auto through =
      cables.Boundary({{scene['R'], {0, 0}}, {scene['R'], {8, 0}}, {scene['R'], {3, 1}, {8, 5}}, {scene['R'], {0, 5}}});
  ASSERT_FALSE(through);
  EXPECT_EQ(through.error().obstruction, WorkspaceObstruction::kLaidCableBlocked);
  EXPECT_THAT(through.error().sides, ElementsAre(2));
  ASSERT_TRUE(through.error().at);
  EXPECT_NEAR(Distance(*through.error().at, {5.5, 3}), 0, 1e-12) << "where it is entered from the anchor";
  EXPECT_THAT(through.error().explanation, HasSubstr("anchor 3"));
  const auto inside = cables.Boundary(Straight({5, 2.5}, corners));
  ASSERT_FALSE(inside);
  EXPECT_EQ(inside.error().obstruction, WorkspaceObstruction::kRobotBlocked);
}

TEST(Boundary, IsThatOfARobotAtAnAnchor) {
  const auto scene = Block();
  const std::vector<Point> corners{{0, 0}, {8, 0}, {8, 5}, {0, 5}};
  const SketchedCables cables(scene.world, corners);
  const std::vector<Polyline> laid{{{0, 0}}, {{0, 0}, {8, 0}}, {{0, 0}, {7, 1}, {8, 5}}, {{0, 0}, {0, 5}}};
  const auto boundary = cables.Boundary(laid);
  ASSERT_TRUE(boundary);
  EXPECT_EQ(boundary->ring, (Ring{{0, 0}, {8, 0}, {8, 5}, {6, 2}, {4, 2}, {0, 5}}));
}

TEST(Anchors, AreAtPlacesOfTheirOwn) {
  const auto scene = Block();
  const CableGround ground = CableGround::Prepare(scene.world).value();
  const auto twice = PlaceAnchors(ground, std::vector<Point>{{0, 0}, {8, 0}, {0, 0}});
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().anchor, 2U);
  EXPECT_THAT(twice.error().text, HasSubstr("cables.anchors[1]"));
  const auto inside = PlaceAnchors(ground, std::vector<Point>{{0, 0}, {5, 2.5}, {8, 5}});
  ASSERT_FALSE(inside);
  EXPECT_EQ(inside.error().anchor, 1U);
}

TEST(Anchors, AreRefusedWhereBlockedGroundTouches) {
  const auto scene = Sketch({"......",  //
                             "..a...",  //
                             "...b..",  //
                             "......"});
  const CableGround ground = CableGround::Prepare(scene.world).value();
  const auto anchors = PlaceAnchors(ground, std::vector<Point>{{0, 0}, {3, 2}, {6, 4}});
  ASSERT_FALSE(anchors);
  EXPECT_EQ(anchors.error().anchor, 1U);
  EXPECT_THAT(anchors.error().text, HasSubstr("either side"));
}

// Cables that come to where blocked ground touches from both sides do not meet.
TEST(Boundary, HasNoRobotBetweenBlocksThatTouch) {
  const auto scene = Sketch({"......",  //
                             "..a...",  //
                             "...b..",  //
                             "......"});
  const std::vector<Point> corners{{0, 0}, {6, 0}, {6, 4}, {0, 4}};
  const SketchedCables cables(scene.world, corners);
  const auto boundary =
      cables.Boundary({{{3, 2}, {0, 0}}, {{3, 2}, {3, 1}, {6, 0}}, {{3, 2}, {6, 4}}, {{3, 2}, {2, 2}, {0, 4}}});
  ASSERT_FALSE(boundary);
  EXPECT_EQ(boundary.error().obstruction, WorkspaceObstruction::kLaidCableBlocked);
  EXPECT_THAT(boundary.error().sides, ElementsAre(2));
  EXPECT_EQ(boundary.error().at, (Point{3, 2}));
}

// The robot keeps the clearance, so that no cable is ever drawn in or paid out along another anchor's socket.
TEST(Boundary, ReachesToTheWallsWithClearance) {
  World world;
  world.outline = {{0, 0}, {10, 0}, {10, 6}, {0, 6}};
  world.clearance = 1;
  const std::vector<Point> points{{0, 3}, {5, 0}, {10, 3}, {5, 6}};
  const SketchedCables cables(world, points);
  const auto boundary = cables.Boundary(Straight({4, 3}, points));
  ASSERT_TRUE(boundary);
  const Ring expected{{0, 3}, {1, 3}, {5, 1}, {5, 0}, {5, 1}, {9, 3}, {10, 3}, {9, 3}, {5, 5}, {5, 6}, {5, 5}, {1, 3}};
  ASSERT_EQ(boundary->ring.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(Distance(boundary->ring[i], expected[i]), 0, 1e-9);
  EXPECT_NEAR(boundary->area, 16, 1e-8);
  EXPECT_NEAR(boundary->length, 8 + 4 * std::sqrt(20), 1e-8);
  const auto longest = LongestCables(cables.ground, cables.anchors, *boundary);
  EXPECT_EQ(longest[0].farthest, 2U);
  EXPECT_NEAR(longest[0].length, 9, 1e-9);
  EXPECT_NEAR(longest[1].length, 1 + std::sqrt(20), 1e-9);
}

}  // namespace
}  // namespace tautline
