#include "tautline/planners/fleet/layout.h"

#include <gtest/gtest.h>

#include <limits>

namespace tautline {
namespace {

/// Three robots, whose targets stand on one line, beside a block.
Scene Yard(const Polyline& cable) {
  Scene scene;
  scene.world.outline = {{-10, -10}, {10, -10}, {10, 10}, {-10, 10}};
  scene.world.obstacles.push_back({.name = "block", .polygon = PolygonWithHoles{{{1, 1}, {3, 1}, {3, 3}, {1, 3}}, {}}});
  scene.fleet.emplace();
  scene.fleet->robots = {
      {.name = "r1", .start = cable.front(), .target = cable.back(), .cable = cable, .speed = 1},
      {.name = "r2", .start = {-5, 5}, .target = {-4, 0}, .cable = Polyline{{-5, 5}, {-4, 0}}, .speed = 1},
      {.name = "r3", .start = {-3, 5}, .target = {-2, 0}, .cable = Polyline{{-3, 5}, {-2, 0}}, .speed = 1}};
  return scene;
}

/// "r1 r2' r3<": names of the nodes of the first cable, targets with ', corners as #, and < or > where they lie to the
/// left or right; or what is wrong with it.
std::string Read(const Polyline& cable) {
  const Scene scene = Yard(cable);
  const auto ground = FleetGround::Prepare(scene);
  if (!ground) return ground.error().message;
  const auto layout = ReadLayout(*ground);
  if (!layout) return Explain(*ground, layout.error());
  std::string text;
  for (const RouteStep& step : layout->front()) {
    const RobotId robot = ground->robot_at(step.node);
    text += (text.empty() ? "" : " ") + (robot.valid() ? ground->robot(robot).name : "#");
    if (ground->kind(step.node) == FleetNodeKind::kTarget) text += "'";
    if (step.side != Side::kNone) text += step.side == Side::kLeft ? "<" : ">";
  }
  return text;
}

TEST(ReadLayout, NamesTheNodesAndTheirSides) {
  EXPECT_EQ(Read({{-6, -1}, {-4, 0}, {-2, 0}, {0, -1}}), "r1 r2'> r3'> r1'");
  EXPECT_EQ(Read({{0, -1}, {-2, 0}, {-4, 0}, {-6, -1}}), "r1 r3'< r2'< r1'");
  EXPECT_EQ(Read({{-6, -1}, {-4, 0}, {-2, 0}, {0, 1}}), "r1 r2'> r3'< r1'");
}

TEST(ReadLayout, AddsWhatTheLinePassesStraight) {
  EXPECT_EQ(Read({{-6, 0}, {0, 0}}), "r1 r2' r3' r1'");
  EXPECT_EQ(Read({{0, 0}, {-6, 0}}), "r1 r3' r2' r1'");
  // Along the flank of the block, and around it.
  EXPECT_EQ(Read({{0, 1}, {5, 1}}), "r1 #< #< r1'");
  EXPECT_EQ(Read({{0, 0}, {1, 1}, {1, 3}, {2, 5}}),
            "the cable line of r1 turns at (1, 1) where nothing would hold it, "
            "pulled taut: leave that point out");
  EXPECT_EQ(Read({{0, 0}, {1, 3}, {2, 4}}), "r1 #> r1'");
}

TEST(ReadLayout, SaysWhatNoCableLineIs) {
  EXPECT_EQ(Read({{0, 2}, {5, 2}}),
            "the cable line of r1 leaves the free space at (1, 2): lead it around what stands there");
  EXPECT_EQ(
      Read({{-6, -1}, {-5, -3}, {0, -1}}),
      "the cable line of r1 bends at (-5, -3), where there is neither the target of another robot nor a corner of "
      "an obstacle: lead it over one, since nothing else holds a taut cable");
  EXPECT_EQ(Read({{-6, 0}, {-2, 0}, {-4, 0}, {-6, 1}}),
            "the cable line of r1 turns at (-2, 0) where nothing would hold it, pulled taut: leave that point out");
}

TEST(BendsOf, LeavesOutWhatIsPassedStraight) {
  const Scene scene = Yard({{-6, 0}, {0, 0}});
  const auto ground = FleetGround::Prepare(scene);
  ASSERT_TRUE(ground);
  const auto layout = ReadLayout(*ground);
  ASSERT_TRUE(layout);
  EXPECT_EQ(BendsOf(*ground, layout->front()).size(), 2u);
  EXPECT_EQ(LengthOf(*ground, layout->front()), 6);
  EXPECT_EQ(PointsOf(*ground, layout->front()), (Polyline{{-6, 0}, {-4, 0}, {-2, 0}, {0, 0}}));
}

}  // namespace
}  // namespace tautline
