#include "tautline/scene/free_space.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/predicates.h"
#include "tautline/geometry/random_rings.h"
#include "tautline/geometry/snap_rounding.h"
#include "tautline/scene/brute_free_space.h"

namespace tautline {
namespace {

World RandomWorld(Rng& rng, const Box& box) {
  World world;
  world.outline = RandomOutline(rng, box);
  world.snap = rng.UniformInt(0, 1) == 0 ? 0 : std::pow(10, rng.Uniform(-9, -3)) * box.size().x;
  for (PolygonWithHoles& polygon : RandomPolygons(rng, box)) {
    Obstacle obstacle;
    obstacle.name = "o" + std::to_string(world.obstacles.size() + 1);
    if (rng.UniformInt(0, 4) == 0) {
      obstacle.circle = Circle{RandomPoint(rng, box), box.size().x * rng.Uniform(0.01, 0.2)};
    } else {
      obstacle.polygon = std::move(polygon);
    }
    world.obstacles.push_back(std::move(obstacle));
  }
  return world;
}

/// Somewhere in the box, or near the boundary of the free space.
Point SamplePoint(Rng& rng, const FreeSpace& space) {
  const int kind = rng.UniformInt(0, 3);
  if (kind == 0 || space.components.empty()) return RandomPoint(rng, space.box);
  const auto pick = [&rng](const auto& list) -> const auto& {
    return list[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(list.size()) - 1))];
  };
  const FreeComponent& component = pick(space.components);
  const bool outer = component.holes.empty() || rng.UniformInt(0, 1) == 0;
  const Ring& ring = outer ? component.outer.points : pick(component.holes).points;
  const auto i = static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(ring.size()) - 1));
  const Point on = Lerp(ring[i], ring[(i + 1) % ring.size()], kind == 1 ? 0 : rng.Uniform());
  const double angle = rng.Uniform(0, 7);
  return on + std::pow(10, rng.Uniform(-11, 0)) * space.box.size().x * Point{std::cos(angle), std::sin(angle)};
}

/// The winding number of all rings that bound an island: -1 on its ground.
int IslandWinding(const FreeSpace& space, ObstacleId island, Point p) {
  int sum = 0;
  const auto add = [&](const BoundaryRing& ring) {
    if (ring.obstacle == island) sum += WindingNumber(ring.points, p).number;
  };
  for (const FreeComponent& component : space.components) {
    add(component.outer);
    std::for_each(component.holes.begin(), component.holes.end(), add);
  }
  return sum;
}

void ExpectWellFormed(const World& world, const FreeSpace& space) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < space.islands.size(); ++i) {
    const Island& island = space.islands[i];
    ASSERT_FALSE(island.members.empty());
    ASSERT_EQ(island.name, island.members[0]);
    ASSERT_GT(island.area, 0);
    ASSERT_FALSE(ComponentOf(space, island.representative));
    ASSERT_EQ(IslandWinding(space, ObstacleId(i), island.representative), -1);
    names.insert(names.end(), island.members.begin(), island.members.end());
  }
  for (const Merge& merge : space.merges) {
    ASSERT_TRUE(merge.with_wall || merge.members.size() > 1);
    if (merge.with_wall) names.insert(names.end(), merge.members.begin(), merge.members.end());
  }
  std::vector<std::string> expected;
  for (const Obstacle& obstacle : world.obstacles) expected.push_back(obstacle.name);
  std::sort(names.begin(), names.end());
  ASSERT_EQ(names, expected);
  for (std::size_t i = 0; i < space.components.size(); ++i) {
    const FreeComponent& component = space.components[i];
    ASSERT_GT(component.area, 0);
    ASSERT_TRUE(i == 0 || component.area <= space.components[i - 1].area);
    ASSERT_GE(component.outer.points.size(), 3u);
    ASSERT_TRUE(std::all_of(component.holes.begin(), component.holes.end(),
                            [](const BoundaryRing& hole) { return hole.obstacle.valid(); }));
  }
}

/// Every boundary vertex is as far from blocked ground as growth carries it: no slit is left open in what was grown.
void ExpectBoundaryAtClearance(const World& world, const FreeSpace& space, double arc_error) {
  const auto check = [&](const BoundaryRing& ring) {
    for (const Point p : ring.points) {
      const BlockedDistance distance = DistanceToBlocked(world, p);
      const double nearest = std::min(distance.straight, distance.disc), slack = 8 * space.grid;
      ASSERT_GE(nearest, world.clearance - slack);
      ASSERT_LE(nearest, world.clearance * (1 + arc_error) + distance.radius * arc_error + slack);
    }
  };
  for (const FreeComponent& component : space.components) {
    check(component.outer);
    std::for_each(component.holes.begin(), component.holes.end(), check);
  }
}

TEST(FreeSpace, AgreesWithDistancesOnRandomWorlds) {
  const std::int64_t count = ScaledTestCount(12000);
  std::int64_t solved = 0;
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const Box box = RandomBox(rng);
    World world = RandomWorld(rng, box);
    world.clearance = rng.UniformInt(0, 3) == 0 ? 0 : box.size().x * std::pow(10, rng.Uniform(-4, -1));
    const FreeSpaceOptions options{.arc_error = std::pow(10, rng.Uniform(-3, 0)), .clearance = {}};
    const Expected<FreeSpace> space = BuildFreeSpace(world, options);
    if (!space) continue;
    ++solved;
    if (world.snap == 0) {
      ExpectWellFormed(world, *space);
      ExpectBoundaryAtClearance(world, *space, options.arc_error);
    }
    for (int k = 0; k < 24; ++k) {
      const Point p = SamplePoint(rng, *space);
      const BlockedDistance distance = DistanceToBlocked(world, p);
      // A vertex moves by the snap tolerance, and again when what it has moved onto moves.
      const double clearance = world.clearance, slack = 16 * space->grid + 8 * world.snap;
      const double straight_limit = clearance * (1 + options.arc_error);
      const double disc_limit = straight_limit + distance.radius * options.arc_error;
      if (std::min(distance.straight, distance.disc) < clearance - (clearance > 0 && world.snap == 0 ? 0 : slack)) {
        ASSERT_EQ(FreeCount(*space, p), 0) << "too small at " << p.x << " " << p.y;
      } else if (distance.straight > straight_limit + slack && distance.disc > disc_limit + slack) {
        ASSERT_EQ(FreeCount(*space, p), 1) << "too large at " << p.x << " " << p.y;
      }
    }
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(solved, count / 2);
}

Obstacle Block(const std::string& name, Point low, Point high) {
  Obstacle obstacle;
  obstacle.name = name;
  obstacle.polygon = PolygonWithHoles{Rectangle(low, high), {}};
  return obstacle;
}

Obstacle Disc(const std::string& name, Point centre, double radius) {
  Obstacle obstacle;
  obstacle.name = name;
  obstacle.circle = Circle{centre, radius};
  return obstacle;
}

World Room(std::vector<Obstacle> obstacles) {
  World world;
  world.outline = Rectangle({0, 0}, {10, 10});
  world.obstacles = std::move(obstacles);
  return world;
}

TEST(FreeSpace, OfAnEmptyRoom) {
  const Expected<FreeSpace> space = BuildFreeSpace(Room({}));
  ASSERT_TRUE(space);
  ASSERT_EQ(space->components.size(), 1u);
  EXPECT_EQ(space->components[0].area, 100);
  EXPECT_EQ(space->components[0].outer.points.size(), 4u);
  EXPECT_FALSE(space->components[0].outer.obstacle.valid());
  EXPECT_TRUE(space->islands.empty() && space->merges.empty() && space->snaps.empty());
  EXPECT_EQ(space->box.high, (Point{10, 10}));
}

TEST(FreeSpace, IslandsStandInTheOrderOfTheScene) {
  const Expected<FreeSpace> space =
      BuildFreeSpace(Room({Block("right", {7, 4}, {8, 6}), Disc("middle", {5, 5}, 1), Block("left", {2, 4}, {3, 6})}));
  ASSERT_TRUE(space);
  ASSERT_EQ(space->islands.size(), 3u);
  EXPECT_EQ(space->name(ObstacleId(0)), "right");
  EXPECT_EQ(space->name(ObstacleId(1)), "middle");
  EXPECT_EQ(space->name(ObstacleId(2)), "left");
  EXPECT_EQ(space->islands[0].area, 2);
  EXPECT_EQ(space->islands[1].representative, (Point{5, 5}));
  EXPECT_GE(space->islands[1].area, std::acos(-1));
  EXPECT_EQ(space->components[0].holes.size(), 3u);
  EXPECT_TRUE(space->merges.empty());
}

TEST(FreeSpace, OverlappingObstaclesTakeTheFirstName) {
  const Expected<FreeSpace> space =
      BuildFreeSpace(Room({Block("a", {1, 1}, {2, 2}), Block("b", {5, 5}, {7, 7}), Block("c", {1.5, 1.5}, {3, 3}),
                           Block("d", {6, 6}, {8, 8}), Block("e", {3, 3}, {4, 4})}));
  ASSERT_TRUE(space);
  ASSERT_EQ(space->islands.size(), 2u);
  EXPECT_EQ(space->islands[0].name, "a");
  EXPECT_EQ(space->islands[0].members, (std::vector<std::string>{"a", "c", "e"}));
  EXPECT_EQ(space->islands[1].members, (std::vector<std::string>{"b", "d"}));
  ASSERT_EQ(space->merges.size(), 2u);
  EXPECT_FALSE(space->merges[0].with_wall);
}

TEST(FreeSpace, ObstaclesWithoutANameAreCalledByPosition) {
  const World world = Room(
      {Block("", {1, 1}, {2, 2}), Block("o3", {3, 1}, {4, 2}), Block("", {5, 1}, {6, 2}), Block("", {5.5, 1}, {7, 2})});
  const Expected<FreeSpace> space = BuildFreeSpace(world);
  ASSERT_TRUE(space);
  EXPECT_EQ(NamesOf(*space), (std::vector<std::string>{"o1", "o3", "o4"}));
  ASSERT_EQ(space->merges.size(), 1u);
  EXPECT_EQ(space->merges[0].members, (std::vector<std::string>{"o4", "o5"}));
}

TEST(FreeSpace, WhatMeetsTheWallIsWall) {
  const Expected<FreeSpace> space = BuildFreeSpace(
      Room({Block("free", {4, 4}, {5, 5}), Block("leaning", {0, 7}, {1, 8}), Block("crossing", {9, 1}, {12, 2}),
            Block("outside", {20, 20}, {21, 21}), Block("indirect", {1, 7}, {2, 8})}));
  ASSERT_TRUE(space);
  ASSERT_EQ(space->islands.size(), 1u);
  EXPECT_EQ(space->islands[0].name, "free");
  ASSERT_EQ(space->merges.size(), 1u);
  EXPECT_TRUE(space->merges[0].with_wall);
  EXPECT_EQ(space->merges[0].members, (std::vector<std::string>{"leaning", "crossing", "outside", "indirect"}));
}

TEST(FreeSpace, AnObstacleWithoutWidthSomewhereIsSeveralIslands) {
  Obstacle dumbbell;
  dumbbell.name = "dumbbell";
  dumbbell.polygon = PolygonWithHoles{
      {{1, 4}, {2, 4}, {2, 5}, {6, 5}, {6, 3}, {9, 3}, {9, 7}, {6, 7}, {6, 5}, {2, 5}, {2, 6}, {1, 6}}, {}};
  World world = Room({dumbbell, Block("dumbbell_2", {1, 1}, {2, 2})});
  const Expected<FreeSpace> space = BuildFreeSpace(world);
  ASSERT_TRUE(space) << ToString(space.error());
  ASSERT_EQ(space->islands.size(), 3u);
  EXPECT_EQ(space->islands[0].name, "dumbbell");
  EXPECT_EQ(space->islands[0].area, 2);
  EXPECT_EQ(space->islands[2].name, "dumbbell_3");
  EXPECT_EQ(space->islands[2].members, std::vector<std::string>{"dumbbell"});
  EXPECT_EQ(space->islands[2].area, 12);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(IslandWinding(*space, ObstacleId(i), space->islands[i].representative), -1) << i;
  }
  world.clearance = 0.1;
  EXPECT_EQ(BuildFreeSpace(world)->islands.size(), 2u) << "grown, its neck has a width";
}

TEST(FreeSpace, ClearanceMergesWhatComesTooNear) {
  World world = Room({Block("a", {2, 2}, {4, 4}), Block("b", {5, 2}, {7, 4}), Block("c", {4, 8}, {5, 9.5})});
  world.clearance = 0.6;
  const Expected<FreeSpace> space = BuildFreeSpace(world);
  ASSERT_TRUE(space);
  ASSERT_EQ(space->islands.size(), 1u);
  EXPECT_EQ(space->islands[0].members, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(space->merges.back().members, (std::vector<std::string>{"c"}));
  EXPECT_TRUE(space->merges.back().with_wall);
  EXPECT_EQ(space->clearance, 0.6);
  EXPECT_FALSE(ComponentOf(*space, {0.5, 5}));
  EXPECT_TRUE(ComponentOf(*space, {0.7, 5}));
  const Expected<FreeSpace> without = BuildFreeSpace(world, {.arc_error = 0.01, .clearance = 0});
  ASSERT_TRUE(without);
  EXPECT_EQ(without->islands.size(), 3u);
}

TEST(FreeSpace, GrowthIsNotTooSmallBesideSomethingHuge) {
  // The coordinate grid is as coarse as the whole scene asks for, and growth must allow for that.
  World world = Room({Block("far", {20, 0}, {1e7, 1e7})});
  for (const double clearance : {0.1, 0.3, 0.6, 0.7, 1.1}) {
    world.clearance = clearance;
    const Expected<FreeSpace> space = BuildFreeSpace(world);
    ASSERT_TRUE(space);
    EXPECT_FALSE(ComponentOf(*space, {clearance - 1e-7, 5})) << clearance;
    EXPECT_GT(space->grid, 1e-6);
  }
}

TEST(FreeSpace, CourtyardsAreComponents) {
  Obstacle yard = Block("yard", {1, 1}, {9, 9});
  yard.polygon->holes.push_back(Rectangle({2, 2}, {8, 8}));
  World world = Room({yard, Block("tree", {4, 4}, {5, 5})});
  const Expected<FreeSpace> space = BuildFreeSpace(world);
  ASSERT_TRUE(space);
  ASSERT_EQ(space->components.size(), 2u);
  EXPECT_EQ(space->components[0].area, 100 - 64);
  EXPECT_EQ(space->components[0].holes[0].obstacle, ObstacleId(0));
  EXPECT_EQ(space->components[1].area, 36 - 1);
  EXPECT_EQ(space->components[1].outer.obstacle, ObstacleId(0));
  EXPECT_EQ(space->components[1].holes[0].obstacle, ObstacleId(1));
  EXPECT_EQ(space->islands[0].area, 64 - 36);
  EXPECT_EQ(ComponentOf(*space, {3, 3}), 1u);
  EXPECT_EQ(ComponentOf(*space, {0.5, 0.5}), 0u);
  EXPECT_EQ(ComponentOf(*space, {1.5, 5}), std::nullopt);
}

TEST(FreeSpace, AGapBelowTheSnapToleranceIsClosedAndReported) {
  World world =
      Room({Block("a", {2, 2}, {4, 4}), Block("b", {4 + 5e-7, 3}, {6, 5}), Block("c", {8, 8}, {9, 10 - 4e-7})});
  const Expected<FreeSpace> space = BuildFreeSpace(world);
  ASSERT_TRUE(space);
  ASSERT_EQ(space->islands.size(), 1u);
  EXPECT_EQ(space->islands[0].members, (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(space->components.size(), 1u) << "no pocket is left in the gap";
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const Snap& snap : space->snaps) pairs.emplace_back(snap.obstacle, snap.onto);
  EXPECT_EQ(std::count(pairs.begin(), pairs.end(), std::pair<std::string, std::string>("c", "wall")), 2);
  EXPECT_EQ(std::count(pairs.begin(), pairs.end(), std::pair<std::string, std::string>("b", "a")), 2);
  EXPECT_EQ(pairs.size(), 4u);
  world.snap = 1e-7;
  const Expected<FreeSpace> apart = BuildFreeSpace(world);
  ASSERT_TRUE(apart);
  EXPECT_EQ(apart->islands.size(), 3u);
  EXPECT_TRUE(apart->snaps.empty());
}

/// Turned about (5, 5).
Ring Turned(const Ring& ring, double angle) {
  Ring turned;
  for (const Point p : ring) {
    turned.push_back(Point{5, 5} + Point{std::cos(angle) * p.x - std::sin(angle) * p.y,
                                         std::sin(angle) * p.x + std::cos(angle) * p.y});
  }
  return turned;
}

TEST(FreeSpace, SmallGapsCloseAtEveryAngle) {
  for (std::int64_t seed = 1; seed <= ScaledTestCount(2000); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const double gap = rng.Uniform(0.01, 0.95) * 1e-6, angle = rng.Uniform(0, 7);
    const Ring table{{-1, -1}, {1, -1}, {1, 0}, {-1, 0}};
    const std::vector<Ring> others{{{rng.Uniform(-0.9, 0.9), gap}, {2, 1}, {-2, 1.5}},
                                   {{-0.5, gap}, {0.5, gap}, {0.6, 1}, {-0.7, 1}},
                                   {{1, gap}, {2, 1}, {-2, 1.5}}};
    for (const Ring& other : others) {
      World world = Room({Block("a", {}, {}), Block("b", {}, {})});
      const bool swapped = rng.UniformInt(0, 1) == 1;
      world.obstacles[0].polygon->outer = Turned(swapped ? other : table, angle);
      world.obstacles[1].polygon->outer = Turned(swapped ? table : other, angle);
      world.clearance = rng.UniformInt(0, 1) * 1e-9;
      const Expected<FreeSpace> space = BuildFreeSpace(world);
      ASSERT_TRUE(space);
      ASSERT_EQ(space->islands.size(), 1u);
      ASSERT_EQ(space->components.size(), 1u);
    }
  }
}

TEST(FreeSpace, AnObstacleThatSnapsToAPointStillGrows) {
  World world = Room({Block("a", {2, 2}, {4, 4}), Block("speck", {4 + 1e-7, 4 + 1e-7}, {4 + 2e-7, 4 + 2e-7})});
  world.clearance = 0.5;
  const Expected<FreeSpace> space = BuildFreeSpace(world);
  ASSERT_TRUE(space);
  ASSERT_EQ(space->islands.size(), 1u);
  EXPECT_EQ(space->islands[0].members, (std::vector<std::string>{"a", "speck"}));
  EXPECT_NEAR(space->islands[0].area, 4 + 4 + std::acos(-1) / 4, 0.01);
}

TEST(FreeSpace, AnObstacleThatSnapsToASpikeStillGrows) {
  // Both long sides of the needle are bent through the corner of the block, so beyond it no area is left.
  World world = Room({Block("block", {2, 2}, {4, 4}), Block("needle", {}, {})});
  world.obstacles[1].polygon->outer = {{1, 4 + 1e-7}, {8, 4 + 1e-7}, {1, 4 + 2e-7}};
  world.clearance = 0.5;
  const Expected<FreeSpace> space = BuildFreeSpace(world);
  ASSERT_TRUE(space);
  EXPECT_FALSE(ComponentOf(*space, {8.4, 4}));
  EXPECT_FALSE(ComponentOf(*space, {6, 4.4}));
  EXPECT_TRUE(ComponentOf(*space, {6, 4.6}));
}

TEST(FreeSpace, NothingFreeIsAnError) {
  World world = Room({Block("all", {-1, -1}, {11, 11})});
  const Expected<FreeSpace> space = BuildFreeSpace(world);
  ASSERT_FALSE(space);
  EXPECT_EQ(space.error().code, ErrorCode::kInvalidInput);
  EXPECT_EQ(space.error().where, "world");
  world.obstacles.clear();
  world.clearance = 6;
  EXPECT_FALSE(BuildFreeSpace(world));
}

TEST(ComponentOf, CountsTheBoundaryAndTheTolerance) {
  const Expected<FreeSpace> space = BuildFreeSpace(Room({Block("divider", {4, 0}, {5, 10})}));
  ASSERT_TRUE(space);
  ASSERT_EQ(space->components.size(), 2u);
  EXPECT_EQ(ComponentOf(*space, {7, 5}), 0u);
  EXPECT_EQ(ComponentOf(*space, {2, 5}), 1u);
  EXPECT_EQ(ComponentOf(*space, {5, 5}), 0u);
  EXPECT_EQ(ComponentOf(*space, {4.9, 5}), std::nullopt);
  EXPECT_EQ(ComponentOf(*space, {4.9, 5}, 0.2), 0u);
  EXPECT_EQ(ComponentOf(*space, {-0.1, 5}, 0.2), 1u);
  // Near to the larger one, but in the other.
  EXPECT_EQ(ComponentOf(*space, {3.9, 5}, 2), 1u);
}

}  // namespace
}  // namespace tautline
