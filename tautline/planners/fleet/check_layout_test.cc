#include "tautline/planners/fleet/check_layout.h"

#include <gtest/gtest.h>

#include "tautline/base/test_scale.h"
#include "tautline/planners/fleet/random_fleet.h"

namespace tautline {
namespace {

FleetRobot Robot(const std::string& name, const Polyline& cable) {
  return {.name = name, .start = cable.front(), .target = cable.back(), .cable = cable, .speed = 1};
}

Scene FleetOf(const std::vector<Polyline>& cables) {
  Scene scene;
  scene.fleet.emplace();
  for (const Polyline& cable : cables) {
    scene.fleet->robots.push_back(Robot("r" + std::to_string(scene.fleet->robots.size() + 1), cable));
  }
  return scene;
}

/// What is wrong with a layout, a sentence each.
std::vector<std::string> FaultsOf(const Scene& scene) {
  const auto ground = FleetGround::Prepare(scene);
  EXPECT_TRUE(ground) << ground.error().message;
  const auto layout = ReadLayout(*ground);
  if (!layout) return {Explain(*ground, layout.error())};
  const LayoutFaults faults = CheckLayout(*ground, *layout);
  std::vector<std::string> found;
  for (const auto& fault : faults.crossings) found.push_back(Explain(*ground, fault));
  for (const auto& fault : faults.self_loops) found.push_back(Explain(*ground, fault));
  for (const auto& fault : faults.starts_enclosed) found.push_back(Explain(*ground, fault));
  for (const auto& fault : faults.short_tethers) found.push_back(Explain(*ground, fault));
  EXPECT_EQ(faults.none(), found.empty());
  return found;
}

using Sentences = std::vector<std::string>;

TEST(CheckLayout, NamesEachCase) {
  EXPECT_EQ(FaultsOf(FleetOf({{{0, 0}, {4, 4}}, {{0, 4}, {4, 0}}})),
            Sentences{"the cable lines of r1 and r2 cross at (2, 2)"});
  // r1 bends at r2's target, which r2 comes to from the other side.
  EXPECT_EQ(FaultsOf(FleetOf({{{0, 0}, {4, 2}, {8, 0}}, {{4, 6}, {4, 2}}})),
            Sentences{"the cable lines of r1 and r2 cross at the target of r2: one of them bends around it, and the "
                      "other one comes from outside"});
  EXPECT_EQ(FaultsOf(FleetOf({{{0, 0}, {4, 2}, {8, 0}}, {{4, -6}, {4, 2}}})), Sentences{});
  // Both bend around the target of r3, one from above and one from below.
  EXPECT_EQ(FaultsOf(FleetOf({{{0, 0}, {4, 2}, {8, 0}}, {{0, 4}, {4, 2}, {8, 4}}, {{4.5, 2}, {4, 2}}})).front(),
            "the cable lines of r1 and r2 cross at the target of r3, around which they bend in opposite ways");
  EXPECT_EQ(FaultsOf(FleetOf({{{0, 1}, {4, 2}, {8, 0}}, {{3, 6}, {4, 2}, {5, -6}}, {{9, 9}, {4, 2}}})).front(),
            "the cable lines of r1 and r2 cross at the target of r3, which both pass");
  // r1 and r2 share the way between the targets of r3 and r4, and change sides on it.
  EXPECT_EQ(
      FaultsOf(FleetOf({{{0, 1}, {2, 0}, {6, 0}, {8, -1}},
                        {{0, -1}, {2, 0}, {6, 0}, {8, 1}},
                        {{2, 5}, {2, 0}},
                        {{6, 5}, {6, 0}}}))
          .front(),
      "the cable lines of r1 and r2 share the way from the target of r3 to the target of r4 and cross there: they "
      "leave it to the other side");
}

TEST(CheckLayout, NamesLoopsStartsAndShortCables) {
  EXPECT_EQ(FaultsOf(FleetOf({{{0, 0}, {4, 0}, {4, 3}, {2, -3}}, {{3.5, 0.25}, {4, 0}}, {{3.75, 2}, {4, 3}}})).front(),
            "the cable line of r1 crosses itself at (3, 0)");
  EXPECT_EQ(
      FaultsOf(FleetOf({{{0, 0}, {4, 4}, {8, 0}}, {{4, 2}, {4, 4}}})),
      Sentences{"the start of r2 lies inside of the polygon of r1, which its cable line and its shortest path bound"});
  EXPECT_EQ(FaultsOf(FleetOf({{{0, 0}, {8, 0}}, {{4, 0}, {4, 4}}})),
            Sentences{"the start of r2 lies on the polygon of r1, which its cable line and its shortest path bound"});
  Scene scene = FleetOf({{{0, 0}, {8, 0}}});
  scene.fleet->robots[0].tether = 7.5;
  EXPECT_EQ(FaultsOf(scene), Sentences{"the cable of r1 is 7.5 m long and its cable line 8 m"});
  scene.fleet->robots[0].tether = 8;
  EXPECT_EQ(FaultsOf(scene), Sentences{});
}

TEST(CheckLayout, ClosesThePolygonAroundObstacles) {
  Scene scene = FleetOf({{{1, 1}, {2, 6}, {8, 6}, {9, 1}}, {{5, 2}, {5, 7}}});
  scene.world.outline = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  scene.world.obstacles.push_back({.name = "block", .polygon = PolygonWithHoles{{{2, 4}, {8, 4}, {8, 6}, {2, 6}}, {}}});
  // Alone in the plane, r2 would start inside of the polygon; here r1's shortest path is its cable line.
  scene.fleet->robots[1].target = {5, 3};
  scene.fleet->robots[1].cable = Polyline{{5, 2}, {5, 3}};
  EXPECT_EQ(FaultsOf(scene), Sentences{});
  scene.fleet->robots[1].cable = Polyline{{5, 2}, {5, 7}};
  scene.fleet->robots[1].target = {5, 7};
  EXPECT_EQ(FaultsOf(scene), Sentences{"the cable line of r2 leaves the free space at (5, 4): lead it around what "
                                       "stands there"});
}

TEST(CheckLayout, FindsTheCrossingsOfAllPairs) {
  constexpr std::uint64_t kSeed = 3;
  Rng rng(kSeed);
  SCOPED_TRACE(kSeed);
  std::size_t crossings = 0;
  for (std::int64_t trial = ScaledTestCount(2'000); trial > 0; --trial) {
    const Scene scene = RandomFleet(rng, 6, 6, trial % 2 == 0);
    const auto ground = FleetGround::Prepare(scene);
    ASSERT_TRUE(ground);
    FleetLayout layout;
    for (std::size_t i = 0; i < ground->size(); ++i) {
      std::optional<Route> route;
      while (!route) route = RandomRoute(rng, *ground, RobotId(i), 3);
      layout.push_back(*route);
    }
    const LayoutFaults faults = CheckLayout(*ground, layout);
    auto found = faults.crossings.begin();
    for (std::size_t i = 0; i < layout.size(); ++i) {
      for (std::size_t j = i + 1; j < layout.size(); ++j) {
        for (const RouteCrossing& crossing : RouteCrossings(*ground, layout[i], layout[j])) {
          ASSERT_NE(found, faults.crossings.end());
          EXPECT_EQ(found->a, RobotId(i));
          EXPECT_EQ(found->b, RobotId(j));
          EXPECT_EQ(found->crossing.kind, crossing.kind);
          EXPECT_EQ(found->crossing.shared, crossing.shared);
          ++found;
          ++crossings;
        }
      }
    }
    EXPECT_EQ(found, faults.crossings.end());
  }
  EXPECT_GT(crossings, 100u);
}

}  // namespace
}  // namespace tautline
