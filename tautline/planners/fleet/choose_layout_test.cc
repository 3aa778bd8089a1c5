#include "tautline/planners/fleet/choose_layout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/planners/fleet/check_layout.h"
#include "tautline/planners/fleet/layouts.h"
#include "tautline/planners/fleet/path_orders.h"
#include "tautline/planners/fleet/plan_fleet.h"
#include "tautline/planners/fleet/playback.h"
#include "tautline/planners/fleet/robot_paths.h"

namespace tautline {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

/// Travel time and total length of the cables.
struct Cost {
  double time = kNone;
  double length = kNone;

  void Improve(double other_time, double other_length) {
    const bool earlier = other_time < time * (1 - 1e-9) || time == kNone;
    if (!earlier && !(other_time < time * (1 + 1e-9) && other_length < length)) return;
    time = other_time;
    length = other_length;
  }
};

Scene RandomTargets(Rng& rng, int robots) {
  Scene scene;
  scene.fleet.emplace();
  const auto place = [&] { return Point{rng.Uniform(0, 10), rng.Uniform(0, 10)}; };
  for (int i = 1; i <= robots; ++i) {
    FleetRobot robot;
    robot.name = "r" + std::to_string(i);
    robot.start = place();
    robot.target = place();
    robot.speed = rng.Uniform(0.5, 1);
    scene.fleet->robots.push_back(robot);
  }
  return scene;
}

World RoomWithPillars(Rng& rng) {
  World world;
  world.outline = {{-1, -1}, {11, -1}, {11, 11}, {-1, 11}};
  for (int i = 1; i <= 2; ++i) {
    const Point at{rng.Uniform(1, 8), rng.Uniform(1, 8)};
    Obstacle obstacle;
    obstacle.name = "o" + std::to_string(i);
    obstacle.polygon = PolygonWithHoles{
        {at, at + Point{rng.Uniform(0.5, 2), 0}, at + Point{rng.Uniform(0.5, 2), rng.Uniform(0.5, 2)}}, {}};
    world.obstacles.push_back(obstacle);
  }
  return world;
}

/// The best over all layouts that there are, each planned.
Cost BestLayout(const FleetGround& ground) {
  Cost best;
  const LayoutsResult found = FindLayouts(ground, {.max_count = 1'000'000});
  EXPECT_TRUE(found.complete);
  for (const FoundLayout& layout : found.layouts) {
    const auto plan = PlanFleet(ground, layout.routes);
    if (plan && plan->modes[0].realizable) best.Improve(plan->travel_time, layout.total);
  }
  return best;
}

/// The best over all orders of passing, each played.
Cost BestOrders(const FleetGround& ground) {
  FleetLayout shortest;
  for (std::size_t i = 0; i < ground.size(); ++i) {
    shortest.push_back({{ground.start(RobotId(i))}, {ground.target(RobotId(i))}});
  }
  const PathOrders paths(ground, ShortestPaths(ground, shortest));
  const std::size_t crossings = paths.crossings().size();
  Cost best;
  for (std::uint64_t bits = 0; bits >> crossings == 0; ++bits) {
    PassingOrders orders;
    for (std::size_t k = 0; k < crossings; ++k) {
      orders.push_back((bits >> k & 1) != 0 ? PassingOrder::kB : PassingOrder::kA);
    }
    const auto time = paths.TravelTime(orders);
    if (!time) continue;
    const auto [schedule, passings] = paths.Schedule(orders);
    const FleetLayout layout = Play(ground, {}, schedule, passings).value().final_routes;
    if (!CheckLayout(ground, layout).none()) continue;
    double length = 0;
    for (const Route& route : layout) length += LengthOf(ground, route);
    best.Improve(*time, length);
  }
  return best;
}

void ExpectSame(const ChosenLayout& chosen, const Cost& best) {
  ASSERT_EQ(chosen.status, best.time == kNone ? ChooseStatus::kInfeasible : ChooseStatus::kSolved);
  if (best.time == kNone) return;
  EXPECT_TRUE(chosen.optimal);
  EXPECT_NEAR(chosen.travel_time, best.time, 1e-9 * best.time);
  EXPECT_NEAR(chosen.length, best.length, 1e-9 * best.length);
}

TEST(ChooseLayoutTest, TwoRobotsThatCross) {
  Scene scene;
  scene.fleet.emplace();
  scene.fleet->robots = {{.name = "r1", .start = {0, 0}, .target = {10, 1}, .cable = {}, .speed = 1, .tether = {}},
                         {.name = "r2", .start = {5, -5}, .target = {5.5, 5}, .cable = {}, .speed = 1, .tether = {}}};
  const FleetGround ground = FleetGround::Prepare(scene).value();
  const ChosenLayout chosen = ChooseLayout(ground);
  ASSERT_EQ(chosen.status, ChooseStatus::kSolved);
  EXPECT_EQ(chosen.crossings, 1u);
  EXPECT_TRUE(chosen.optimal);
  // If r2 passes first, r1 need not wait, and its cable bends around nothing, but that of r2 bends around r1.
  EXPECT_NEAR(chosen.travel_time, std::hypot(10, 1), 1e-9);
  EXPECT_LE(chosen.length, std::hypot(10, 1) + std::hypot(5, 6) + std::hypot(4.5, 4) + 1e-9);
}

TEST(ChooseLayoutTest, AgreesWithAllLayoutsPlanned) {
  int solved = 0, bent = 0;
  const std::int64_t count = ScaledTestCount(100);
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const FleetGround ground = FleetGround::Prepare(RandomTargets(rng, rng.UniformInt(2, 4))).value();
    const ChosenLayout chosen = ChooseLayout(ground);
    ExpectSame(chosen, BestLayout(ground));
    solved += chosen.status == ChooseStatus::kSolved;
    for (const Route& route : chosen.layout) bent += route.size() > 2;
  }
  EXPECT_GT(solved, count / 2 - 2);
  EXPECT_GT(bent, count / 4 - 2);
}

TEST(ChooseLayoutTest, AgreesWithAllOrdersPlayed) {
  for (std::int64_t seed = 1; seed <= ScaledTestCount(100); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const FleetGround ground = FleetGround::Prepare(RandomTargets(rng, rng.UniformInt(3, 5))).value();
    ExpectSame(ChooseLayout(ground), BestOrders(ground));
  }
}

TEST(ChooseLayoutTest, WhatItChoosesAmongPillarsIsWhatThePlannerMakes) {
  int solved = 0;
  const std::int64_t count = ScaledTestCount(100);
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    Scene scene = RandomTargets(rng, 4);
    scene.world = RoomWithPillars(rng);
    const FleetGround ground = FleetGround::Prepare(scene).value();
    const ChosenLayout chosen = ChooseLayout(ground);
    if (chosen.status != ChooseStatus::kSolved) continue;
    ++solved;
    const FleetPlan plan = PlanFleet(ground, chosen.layout).value();
    EXPECT_TRUE(plan.modes[0].realizable);
    EXPECT_NEAR(plan.travel_time, chosen.travel_time, 1e-9 * chosen.travel_time);
    EXPECT_EQ(plan.passings.size(), chosen.crossings);
    EXPECT_TRUE(Play(ground, chosen.layout, plan.schedule, plan.passings).value().matches());
  }
  EXPECT_GT(solved, count / 4 - 2);
}

TEST(ChooseLayoutTest, ATetherThatIsTooShortForOneOrderAsksForTheOther) {
  Scene scene;
  scene.fleet.emplace();
  scene.fleet->robots = {{.name = "r1", .start = {0, 0}, .target = {10, 1}, .cable = {}, .speed = 1, .tether = {}},
                         {.name = "r2", .start = {5, -5}, .target = {5.5, 5}, .cable = {}, .speed = 1, .tether = {}}};
  const ChosenLayout free = ChooseLayout(FleetGround::Prepare(scene).value());
  // Whichever cable was bent must now be straight.
  for (std::size_t i = 0; i < 2; ++i) {
    FleetRobot& robot = scene.fleet->robots[i];
    if (free.layout[i].size() > 2) robot.tether = Distance(robot.start, robot.target) + 0.01;
  }
  const ChosenLayout tied = ChooseLayout(FleetGround::Prepare(scene).value());
  ASSERT_EQ(tied.status, ChooseStatus::kSolved);
  EXPECT_NE(tied.layout, free.layout);
  for (FleetRobot& robot : scene.fleet->robots) robot.tether = Distance(robot.start, robot.target) + 0.01;
  const ChosenLayout none = ChooseLayout(FleetGround::Prepare(scene).value());
  EXPECT_EQ(none.status, ChooseStatus::kInfeasible);
  EXPECT_FALSE(none.explanation.empty());
}

TEST(ChooseLayoutTest, ASmallBudgetStillGivesALayout) {
  Rng rng(1);
  Scene scene;
  scene.fleet.emplace();
  for (int i = 0; i < 8; ++i) {
    FleetRobot robot;
    robot.name = "r" + std::to_string(i + 1);
    robot.start = {static_cast<double>(i), 0};
    robot.target = {rng.Uniform(-1, 8), rng.Uniform(1, 9)};
    robot.speed = 1;
    scene.fleet->robots.push_back(robot);
  }
  const FleetGround ground = FleetGround::Prepare(scene).value();
  const ChosenLayout one = ChooseLayout(ground, {.budget = 1});
  const ChosenLayout many = ChooseLayout(ground, {.budget = 200});
  ASSERT_EQ(one.status, ChooseStatus::kSolved);
  ASSERT_EQ(many.status, ChooseStatus::kSolved);
  EXPECT_FALSE(one.optimal);
  EXPECT_EQ(one.played, 1);
  EXPECT_LE(many.played, 200);
  EXPECT_LT(many.length, one.length);
  EXPECT_NEAR(many.travel_time, one.travel_time, 1e-9);
  int calls = 0;
  const ChosenLayout stopped = ChooseLayout(ground, {.watch = [&](std::string_view, double) { return ++calls < 5; }});
  EXPECT_EQ(stopped.status, ChooseStatus::kSolved);
  EXPECT_EQ(stopped.played, 4);
}

}  // namespace
}  // namespace tautline
