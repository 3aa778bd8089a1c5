#include "bench/peers/fleet_as_printed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tautline/planners/fleet/driven_fleet.h"
#include "tautline/planners/fleet/plan_fleet.h"

namespace tautline {
namespace {

using Pairs = std::vector<std::pair<RobotId, RobotId>>;

Pairs PairsOf(const std::vector<std::pair<int, int>>& numbers) {
  Pairs pairs;
  for (const auto& [a, b] : numbers) pairs.emplace_back(RobotId(a - 1), RobotId(b - 1));
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Pairs Sorted(Pairs pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// Robots r1, r2, ... with these cable lines, 1 m/s.
Scene FleetOf(const std::vector<Polyline>& cables) {
  Scene scene;
  scene.fleet.emplace();
  for (const Polyline& cable : cables) {
    scene.fleet->robots.push_back({.name = "r" + std::to_string(scene.fleet->robots.size() + 1),
                                   .start = cable.front(),
                                   .target = cable.back(),
                                   .cable = cable,
                                   .speed = 1,
                                   .tether = {}});
  }
  return scene;
}

PrintedPlan Plan(const std::vector<Polyline>& cables) {
  const FleetGround ground = FleetGround::Prepare(FleetOf(cables)).value();
  return PlanAsPrinted(ground, ReadLayout(ground).value());
}

TEST(FleetAsPrintedTest, TheRobotThatPushesPassesSecond) {
  const PrintedPlan plan = Plan({{{0, 0}, {5.5, 5}, {10, 1}}, {{5, -5}, {5.5, 5}}});
  EXPECT_EQ(plan.passings, PairsOf({{1, 2}}));
  EXPECT_TRUE(plan.detours.empty());
  EXPECT_NEAR(plan.travel_time, 10.04987562112089, 1e-9);
}

TEST(FleetAsPrintedTest, ACircleOfPrioritiesIsNoDeadlock) {
  const Point t1{6.0898, -0.595}, t2{-2.5296, 5.5714}, t3{-3.5602, -4.9764};
  const PrintedPlan plan =
      Plan({{{-6.8452, -1.8928}, t3, t1}, {{5.0619, -4.9817}, t1, t2}, {{1.7834, 6.8746}, t2, t3}});
  EXPECT_EQ(Sorted(plan.passings), PairsOf({{1, 3}, {2, 1}, {3, 2}}));
  EXPECT_TRUE(plan.detours.empty());
  EXPECT_NEAR(plan.travel_time, 13.000010075380713, 1e-9);
}

TEST(FleetAsPrintedTest, OneOfAPairInDeadlockDrivesLast) {
  const Point t1{9.8, 17.2}, t2{11.4, 6.2};
  const std::vector<Polyline> cables{{{10, 0.2}, t2, t1}, {{17.2, 18.2}, t1, t2}};
  const PrintedPlan plan = Plan(cables);
  EXPECT_TRUE(plan.passings.empty());
  EXPECT_EQ(plan.pair_deadlocks, PairsOf({{1, 2}}));
  ASSERT_EQ(plan.detours.size(), 1u);
  EXPECT_EQ(plan.detours[0], RobotId(0));
  EXPECT_NEAR(plan.travel_time, Distance(cables[1][0], t2) + Distance(cables[0][0], t2) + Distance(t2, t1), 1e-9);
}

TEST(FleetAsPrintedTest, TheOrdersOfFigure11) {
  const Point t1{5.3, 11.2}, t2{9.3, 14.0}, t4{8.4, 19.7}, t5{19.1, 15.9};
  const PrintedPlan plan = Plan({{{19.3, 16.2}, t5, t2, t1},
                                 {{15.5, 13.7}, t2},
                                 {{11.7, 12.4}, t1, t4, {3.2, 6.4}},
                                 {{13.6, 4.7}, t1, t4},
                                 {{5.0, 14.2}, t4, t5}});
  EXPECT_EQ(Sorted(plan.passings), PairsOf({{1, 2}, {1, 5}, {3, 4}, {4, 1}, {4, 2}, {5, 4}}));
  EXPECT_TRUE(plan.detours.empty());
  EXPECT_NEAR(plan.travel_time, 15.875767697972908, 1e-9);
}

TEST(FleetAsPrintedTest, FindsWhatTheLibraryFindsInRandomRows) {
  std::size_t passings = 0, deadlocks = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const Scene scene = FleetInRows(rng, {.robots = 40, .row = 20, .detours = 0.2});
    const FleetGround ground = FleetGround::Prepare(scene).value();
    const FleetLayout layout = ReadLayout(ground).value();
    const FleetPlan plan = PlanFleet(ground, layout, {.play = false}).value();
    const PrintedPlan printed = PlanAsPrinted(ground, layout);
    Pairs orders, pairs;
    for (const Passing& passing : plan.passings) orders.emplace_back(passing.first, passing.second);
    for (const PairDeadlock& pair : plan.pair_deadlocks) pairs.emplace_back(pair.a, pair.b);
    EXPECT_EQ(Sorted(printed.passings), Sorted(orders));
    EXPECT_EQ(Sorted(printed.pair_deadlocks), Sorted(pairs));
    EXPECT_EQ(printed.detours.empty(), plan.detours.empty());
    EXPECT_GE(printed.detours.size(), plan.detours.size());
    if (printed.detours.empty()) {
      EXPECT_NEAR(printed.travel_time, plan.travel_time, 1e-9 * plan.travel_time);
    }
    passings += orders.size();
    deadlocks += pairs.size();
  }
  EXPECT_GT(passings, 1000u);
  EXPECT_GT(deadlocks, 5u);
}

}  // namespace
}  // namespace tautline
