#include "tautline/scene/check_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

namespace tautline {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

World Room() {
  World world;
  world.outline = {{0, 0}, {20, 0}, {20, 10}, {0, 10}};
  Obstacle pillar;
  pillar.name = "pillar";
  pillar.polygon = PolygonWithHoles{{{4, 4}, {6, 4}, {6, 6}, {4, 6}}, {{{4.5, 4.5}, {5, 4.5}, {5, 5}}}};
  Obstacle tank;
  tank.name = "tank";
  tank.circle = Circle{{12, 5}, 1.5};
  world.obstacles = {pillar, tank};
  return world;
}

/// What is wrong with the room after a change, as BuildFreeSpace says it.
template <class Change>
std::string ErrorAfter(Change change) {
  World world = Room();
  FreeSpaceOptions options;
  change(world, options);
  const auto space = BuildFreeSpace(world, options);
  return space ? "no error" : ToString(space.error());
}

template <class Change>
std::string ErrorOfWorld(Change change) {
  return ErrorAfter([&change](World& world, FreeSpaceOptions&) { change(world); });
}

TEST(CheckWorld, AGoodRoomIsGood) {
  EXPECT_EQ(ErrorOfWorld([](World&) {}), "no error");
  EXPECT_EQ(ErrorOfWorld([](World& world) { std::reverse(world.outline.begin(), world.outline.end()); }), "no error");
  EXPECT_EQ(ErrorOfWorld([](World& world) { world.outline.push_back(world.outline.front()); }), "no error");
}

TEST(CheckWorld, TheOutlineIsARing) {
  EXPECT_EQ(ErrorOfWorld([](World& world) { world.outline.clear(); }).substr(0, 34),
            "world: the scene has no world; add");
  EXPECT_EQ(ErrorOfWorld([](World& world) { world.outline.resize(2); }),
            "world.outline has 2 points: it needs 3 or more");
  EXPECT_EQ(ErrorOfWorld([](World& world) {
              world.outline = {{0, 0}, {1, 1}, {2, 2}};
            }),
            "world.outline has no area: its points lie on a line");
  EXPECT_EQ(ErrorOfWorld([](World& world) { std::swap(world.outline[1], world.outline[2]); }),
            "world.outline crosses itself: edge 1 (0, 0)-(20, 10) meets edge 3 (20, 0)-(0, 10); list the points in "
            "order around it");
  EXPECT_EQ(ErrorOfWorld([](World& world) { world.outline[2].x = kNan; }),
            "world.outline[3] is not a number: coordinates must be finite");
}

TEST(CheckWorld, AnObstacleHasOneShape) {
  EXPECT_EQ(ErrorOfWorld([](World& world) { world.obstacles[0].polygon.reset(); }),
            "world.obstacles[1] 'pillar' must have exactly one of 'polygon' and 'circle'");
  EXPECT_EQ(ErrorOfWorld([](World& world) { world.obstacles[1].polygon = world.obstacles[0].polygon; }),
            "world.obstacles[2] 'tank' must have exactly one of 'polygon' and 'circle'");
}

TEST(CheckWorld, PolygonsAreRings) {
  const auto with_outer = [](Ring ring) {
    return ErrorOfWorld([&ring](World& world) { world.obstacles[0].polygon->outer = ring; });
  };
  EXPECT_EQ(with_outer({}), "world.obstacles[1] 'pillar'.polygon has 0 points: it needs 3 or more");
  EXPECT_EQ(with_outer({{4, 4}, {6, 4}}), "world.obstacles[1] 'pillar'.polygon has 2 points: it needs 3 or more");
  EXPECT_EQ(with_outer({{4, 4}, {4, 4}, {4, 4}}),
            "world.obstacles[1] 'pillar'.polygon has no area: its points lie on a line");
  EXPECT_EQ(with_outer({{4, 4}, {6, -kInfinity}, {6, 6}}),
            "world.obstacles[1] 'pillar'.polygon[2] is infinite: coordinates must be finite");
  EXPECT_EQ(with_outer({{4, 4}, {6, 4}, {1.5e7, 6}}),
            "world.obstacles[1] 'pillar'.polygon[3] is 1.5e+07: coordinates go up to 1e7 metres; move the origin "
            "nearer or check the units");
  EXPECT_EQ(ErrorOfWorld([](World& world) { world.obstacles[0].polygon->holes.push_back({}); }),
            "world.obstacles[1] 'pillar'.polygon hole has 0 points: it needs 3 or more");
  EXPECT_EQ(ErrorOfWorld([](World& world) { world.obstacles[0].polygon->holes[0][1].x = 7; }),
            "world.obstacles[1] 'pillar'.polygon hole does not lie inside the polygon: move it or leave it out");
  EXPECT_EQ(ErrorOfWorld([](World& world) {
              world.obstacles[0].from_map = true;
              world.obstacles[0].polygon->outer[1].y = kNan;
            }),
            "world.obstacles[1] 'pillar'.polygon[2] is not a number: coordinates must be finite");
}

TEST(CheckWorld, CirclesHaveARadiusAndAPlace) {
  const auto with_circle = [](Circle circle) {
    return ErrorOfWorld([circle](World& world) { world.obstacles[1].circle = circle; });
  };
  EXPECT_EQ(with_circle({{1, 1}, 0}), "world.obstacles[2] 'tank'.circle radius is 0: it must be larger than 0");
  EXPECT_EQ(with_circle({{1, 1}, kNan}), "world.obstacles[2] 'tank'.circle radius is not a number: it must be finite");
  EXPECT_EQ(with_circle({{kNan, 1}, 1}).substr(0, 80),
            "world.obstacles[2] 'tank'.circle reaches a point that is not a number: coordinat");
  EXPECT_EQ(with_circle({{9e6, 1}, 2e6}).substr(0, 62),
            "world.obstacles[2] 'tank'.circle reaches a point that is 1.1e+");
}

TEST(CheckWorld, RepresentativesLieInside) {
  const auto with_point = [](Point p) {
    return ErrorOfWorld([p](World& world) { world.obstacles[0].representative = p; });
  };
  EXPECT_EQ(with_point({5.5, 5.5}), "no error");
  EXPECT_EQ(with_point({4.8, 4.6}),
            "world.obstacles[1] 'pillar'.representative (4.8, 4.6) does not lie strictly inside the obstacle: "
            "move it or leave it out");
  EXPECT_EQ(with_point({kNan, 5}),
            "world.obstacles[1] 'pillar'.representative is not a number: coordinates must be finite");
}

TEST(CheckWorld, SizesAreNotNegative) {
  EXPECT_EQ(ErrorOfWorld([](World& world) { world.clearance = -1; }), "world.clearance is -1: it must not be negative");
  EXPECT_EQ(ErrorOfWorld([](World& world) { world.clearance = kNan; }),
            "world.clearance is not a number: it must be finite");
  EXPECT_EQ(ErrorOfWorld([](World& world) { world.snap = -kInfinity; }), "world.snap is infinite: it must be finite");
  EXPECT_EQ(ErrorAfter([](World&, FreeSpaceOptions& options) { options.clearance = -0.5; }),
            "clearance is -0.5: it must not be negative");
}

TEST(CheckWorld, ArcErrorIsAShareOfTheRadius) {
  const auto with_error = [](double error) {
    return ErrorAfter([error](World& world, FreeSpaceOptions& options) {
      world.outline = {{-1e7, -1e7}, {1e7, -1e7}, {1e7, 1e7}, {-1e7, 1e7}};
      world.obstacles[1].circle = Circle{{0, 0}, 0.9e7};
      options.arc_error = error;
    });
  };
  EXPECT_EQ(with_error(kSmallestArcError), "no error");
  EXPECT_EQ(with_error(1), "no error");
  for (const double error : {0.0, -0.1, 1e-9, 1.5, kNan, kInfinity}) {
    EXPECT_EQ(with_error(error), "arc_error must lie between 1e-06 and 1, a share of the radius") << error;
  }
}

TEST(CheckWorld, TooManyCornersAreRefusedBeforeAnyWork) {
  const auto crowd = [](World& world, FreeSpaceOptions& options) {
    options.arc_error = kSmallestArcError;
    const Obstacle tank = world.obstacles[1];
    world.obstacles.assign(2000, tank);
  };
  EXPECT_EQ(ErrorAfter(crowd),
            "world has 4444004 corners, more than 4000000: simplify it (maps: --simplify METRES), or raise arc_error "
            "if you set it");
  EXPECT_EQ(ErrorAfter([](World& world, FreeSpaceOptions& options) {
              options.arc_error = kSmallestArcError;
              world.clearance = 0.1;
              Ring& comb = world.obstacles[0].polygon->outer;
              world.obstacles[0].polygon->holes.clear();
              comb = {{1, 1}};
              for (int i = 0; i < 120000; ++i) comb.push_back({1 + 1e-4 * i, 2.0 + i % 2});
              comb.push_back({13, 1});
            }).find("corners with its clearance, more than 64000000: simplify it"),
            19u);
}

}  // namespace
}  // namespace tautline
