#include "tautline/planners/fleet/fleet_ground.h"

#include <gtest/gtest.h>

#include "tautline/base/test_scale.h"
#include "tautline/geometry/predicates.h"
#include "tautline/planners/fleet/random_fleet.h"

namespace tautline {
namespace {

TEST(FleetGround, ListsStartsTargetsAndCorners) {
  Rng rng(1);
  Scene scene = RandomFleet(rng, 2, 10, false);
  scene.world.outline = {{-1, -1}, {20, -1}, {20, 20}, {-1, 20}};
  scene.world.obstacles.push_back({.name = "block", .polygon = PolygonWithHoles{{{12, 12}, {14, 12}, {14, 14}}, {}}});
  const auto ground = FleetGround::Prepare(scene);
  ASSERT_TRUE(ground) << ground.error().message;
  EXPECT_EQ(ground->node_count(), 7u);
  EXPECT_EQ(NameOf(*ground, FleetNodeId(0)), "the start of r1");
  EXPECT_EQ(NameOf(*ground, FleetNodeId(3)), "the target of r2");
  EXPECT_EQ(NameOf(*ground, *ground->NodeAt({14, 14})), "the corner (14, 14)");
  for (std::size_t k = 0; k < ground->node_count(); ++k) {
    EXPECT_EQ(ground->NodeAt(ground->point(FleetNodeId(k))), FleetNodeId(k));
  }
  EXPECT_EQ(ground->NodeAt({15, 15}), std::nullopt);
}

TEST(FleetGround, RefusesAnEndAtACorner) {
  Rng rng(1);
  Scene scene = RandomFleet(rng, 2, 10, false);
  scene.world.outline = {{-1, -1}, {20, -1}, {20, 20}, {-1, 20}};
  scene.world.obstacles.push_back({.name = "block", .polygon = PolygonWithHoles{{{12, 12}, {14, 12}, {14, 14}}, {}}});
  scene.fleet->robots[1].target = {14, 14};
  const auto ground = FleetGround::Prepare(scene);
  ASSERT_FALSE(ground);
  EXPECT_NE(ground.error().message.find("the target of r2 is on the corner of an obstacle, at (14, 14)"),
            std::string::npos);
  // Nor may it be so near that the rounding of the free space decides.
  scene.fleet->robots[1].target = {14 + 1e-9, 14 - 1e-9};
  EXPECT_FALSE(FleetGround::Prepare(scene));
  scene.fleet->robots[1].target = {14.01, 14};
  EXPECT_TRUE(FleetGround::Prepare(scene));
}

TEST(NodesBetween, AreThoseOnTheSegmentInOrder) {
  Rng rng(4);
  std::size_t found = 0;
  for (std::int64_t trial = ScaledTestCount(200); trial > 0; --trial) {
    const auto ground = FleetGround::Prepare(RandomFleet(rng, 8, 5, true));
    ASSERT_TRUE(ground);
    const Point a{static_cast<double>(rng.UniformInt(0, 5)), static_cast<double>(rng.UniformInt(0, 5))};
    const Point b{static_cast<double>(rng.UniformInt(0, 5)), static_cast<double>(rng.UniformInt(0, 5))};
    std::vector<FleetNodeId> expected;
    for (std::size_t k = 0; k < ground->node_count(); ++k) {
      const Point p = ground->point(FleetNodeId(k));
      if (p != a && p != b && OnSegment(a, b, p)) expected.push_back(FleetNodeId(k));
    }
    std::vector<FleetNodeId> nodes = ground->NodesBetween(a, b);
    for (std::size_t k = 1; k < nodes.size(); ++k) {
      EXPECT_LT(Distance(a, ground->point(nodes[k - 1])), Distance(a, ground->point(nodes[k])));
    }
    std::sort(nodes.begin(), nodes.end());
    EXPECT_EQ(nodes, expected);
    found += nodes.size();
  }
  EXPECT_GT(found, 0u);
}

}  // namespace
}  // namespace tautline
