#include "tautline/planners/cable_workspace/moved_world.h"

#include <gtest/gtest.h>

#include "tautline/geometry/random_rings.h"
#include "tautline/homotopy/print_point.h"

namespace tautline {
namespace {

World RoomOfThree() {
  World world;
  world.outline = Rectangle({0, 0}, {20, 10});
  world.obstacles.resize(3);
  world.obstacles[0].name = "frame";
  world.obstacles[0].polygon = PolygonWithHoles{Rectangle({1, 1}, {5, 5}), {Rectangle({2, 2}, {4, 4})}};
  world.obstacles[1].circle = Circle{{10, 5}, 2};
  world.obstacles[2].name = "post";
  world.obstacles[2].polygon = PolygonWithHoles{Rectangle({14, 4}, {16, 6}), {}};
  world.obstacles[2].representative = Point{14.5, 4.5};
  return world;
}

TEST(MoveObstacles, MovesShapesAndRepresentatives) {
  const World world = RoomOfThree();
  const Future future{1, {{"frame", {{1.5, 3}, {2, 3}, {2.5, 4}}}, {"o2", {{11, 5}, {11, 6}}}}};
  const MovedWorld moved = MoveObstacles(world, future, 0).value();
  EXPECT_EQ(moved.offsets, (std::vector<Point>{{1, 1}, {0, 1}, {0, 0}}));
  EXPECT_EQ(moved.world.obstacles[0].polygon->outer, Rectangle({2, 2}, {6, 6}));
  EXPECT_EQ(moved.world.obstacles[0].polygon->holes[0], Rectangle({3, 3}, {5, 5}));
  EXPECT_EQ(moved.world.obstacles[0].representative, (moved.representatives[0] + Point{1, 1}));
  EXPECT_EQ(moved.world.obstacles[1].circle, (Circle{{10, 6}, 2}));
  EXPECT_EQ(moved.world.obstacles[1].representative, (Point{10, 6}));
  EXPECT_EQ(moved.world.obstacles[2].polygon, world.obstacles[2].polygon);
  EXPECT_EQ(moved.world.obstacles[2].representative, world.obstacles[2].representative);
  ASSERT_EQ(moved.steps.size(), 3u);
  EXPECT_EQ(moved.steps[0].offset, (Point{0.5, 0}));
  EXPECT_EQ(moved.steps[1].offset, (Point{1, 1}));
  EXPECT_EQ(moved.steps[2].obstacle, 1u);
  EXPECT_EQ(moved.steps[2].move, 1u);
}

TEST(MoveObstacles, GoesOnFromWhereAnObstacleIs) {
  const Future future{1, {{"post", {{14.5, 4.5}, {16, 4.5}}}, {"post", {{16, 4.5}, {16, 7}}}}};
  const MovedWorld moved = MoveObstacles(RoomOfThree(), future, 0).value();
  EXPECT_EQ(moved.offsets[2], (Point{1.5, 2.5}));
  EXPECT_EQ(moved.steps[1].offset, (Point{1.5, 2.5}));
  EXPECT_EQ(moved.world.obstacles[2].representative, (Point{16, 7}));
}

TEST(MoveObstacles, APathStartsAtItsObstacle) {
  const auto error = [](const std::string& name, Point start) {
    const auto moved = MoveObstacles(RoomOfThree(), {1, {{name, {start, {3, 3}}}}}, 4);
    return moved ? "" : ToString(moved.error());
  };
  EXPECT_EQ(error("frame", {3, 3}),
            "futures[5].moves[1]: the path of 'frame' must start inside of the obstacle, where it is by then, not at "
            "(3, 3)")
      << "in its hole";
  EXPECT_EQ(error("frame", {5, 3}), "") << "on its boundary";
  EXPECT_EQ(error("o2", {11.9, 5}), "");
  EXPECT_NE(error("o2", {12.1, 5}), "");
  EXPECT_EQ(error("post", {14.5, 4.50001}), "") << "within a millionth of the world";
  EXPECT_NE(error("post", {15, 5}), "") << "inside, but its representative is another point";
}

TEST(MoveObstacles, AVeryThinObstacleFindsAnotherRepresentative) {
  World world = RoomOfThree();
  const double thin = 0x1p-50;
  world.obstacles[2].polygon = PolygonWithHoles{Rectangle({0.25, 4}, {0.25 + 2 * thin, 6}), {}};
  world.obstacles[2].representative = Point{0.25 + thin, 5};
  const MovedWorld moved = MoveObstacles(world, {1, {{"post", {{0.25, 5}, {1e6 + 0.25, 5}}}}}, 0).value();
  EXPECT_FALSE(moved.world.obstacles[2].representative.has_value());
}

}  // namespace
}  // namespace tautline
