#include "tautline/planners/fleet/plan_fleet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/planners/fleet/check_layout.h"
#include "tautline/planners/fleet/playback.h"
#include "tautline/planners/fleet/schedule.h"

namespace tautline {
namespace {

/// Robots from their cable lines, 1 m/s.
Scene FleetOf(const std::vector<Polyline>& cables) {
  Scene scene;
  scene.fleet.emplace();
  for (std::size_t i = 0; i < cables.size(); ++i) {
    FleetRobot robot;
    robot.name = "r" + std::to_string(i + 1);
    robot.start = cables[i].front();
    robot.target = cables[i].back();
    robot.cable = cables[i];
    robot.speed = 1;
    scene.fleet->robots.push_back(robot);
  }
  return scene;
}

/// Fig. 10(a): each robot waits for another one, and all can go at once.
std::vector<Polyline> Fig10a() {
  return {{{6, 0}, {3, 5.5}, {7, 8.8}}, {{11.2, 9}, {7.9, 3.7}, {3, 5.5}}, {{0.8, 9}, {7, 8.8}, {7.9, 3.7}}};
}

tl::expected<FleetPlan, FleetPlanFault> PlanOf(const Scene& scene, const FleetPlanOptions& options = {}) {
  const auto ground = FleetGround::Prepare(scene);
  return PlanFleet(*ground, *ReadLayout(*ground), options);
}

TEST(PlanFleet, TwoRobotsNeedNotWaitForEachOther) {
  // Fig. 9(d): the paper's rule of waiting, read literally, would take 15.3 s.
  const Scene scene = FleetOf({{{0, 0}, {5.5, 5}, {10, 1}}, {{5, -5}, {5.5, 5}}});
  const auto plan = PlanOf(scene);
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->passings.size(), 1U);
  EXPECT_EQ(plan->passings[0].first, RobotId(0));
  EXPECT_EQ(plan->passings[0].label, "A");
  EXPECT_NEAR(plan->travel_time, std::sqrt(101.0), 1e-12);
}

TEST(PlanFleet, CircleOfEventsNeedsOneDetour) {
  const auto plan = PlanOf(FleetOf(Fig10a()));
  ASSERT_TRUE(plan);
  EXPECT_TRUE(plan->pair_deadlocks.empty());
  EXPECT_EQ(plan->network_deadlocks.size(), 1U);
  EXPECT_EQ(plan->detours.size(), 1U);
  EXPECT_TRUE(plan->modes[0].detours_optimal);
  // Of the three, the shortest detour.
  const auto length = [](const Polyline& line) { return Length(line) - Distance(line.front(), line.back()); };
  std::vector<double> costs;
  for (const Polyline& cable : Fig10a()) costs.push_back(length(cable));
  EXPECT_EQ(plan->detours[0].index(), std::min_element(costs.begin(), costs.end()) - costs.begin());
}

TEST(PlanFleet, MirroredScenesHaveMirroredPlans) {
  std::vector<Polyline> mirrored = Fig10a();
  for (Polyline& line : mirrored) {
    for (Point& p : line) p.x = -p.x;
  }
  const auto plan = PlanOf(FleetOf(Fig10a())), image = PlanOf(FleetOf(mirrored));
  ASSERT_TRUE(plan && image);
  EXPECT_EQ(plan->detours, image->detours);
  ASSERT_EQ(plan->passings.size(), image->passings.size());
  for (std::size_t k = 0; k < plan->passings.size(); ++k) {
    EXPECT_EQ(plan->passings[k].first, image->passings[k].first);
    EXPECT_EQ(plan->passings[k].at.x, -image->passings[k].at.x);
  }
  EXPECT_EQ(plan->travel_time, image->travel_time);
}

TEST(PlanFleet, SpeedsInsteadOfWaitsArriveAtTheSameTimes) {
  const auto waits = PlanOf(FleetOf(Fig10a())), speeds = PlanOf(FleetOf(Fig10a()), {.speeds = true});
  ASSERT_TRUE(waits && speeds);
  int slower = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &a = waits->schedule[i].events, &b = speeds->schedule[i].events;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t e = 1; e < a.size(); ++e) {
      EXPECT_EQ(a[e].departure, b[e].departure);
      EXPECT_EQ(b[e].arrival, b[e].departure) << "stops";
      slower += a[e].arrival < b[e].arrival;
    }
  }
  EXPECT_GE(slower, 1);
}

TEST(PlanFleet, DetoursOverATargetPassTheCableThatLeadsAlongThem) {
  // The second leads straight over the target of the first, whose cable comes there along the same line: only where
  // both leave the pin at (5, 10) tells that the second passes above.
  const Scene scene = FleetOf({{{3, 6}, {5, 10}, {4, 10}}, {{1, 10}, {5, 10}, {7, 4}}, {{2, 7}, {5, 10}}});
  const auto ground = FleetGround::Prepare(scene);
  const auto layout = ReadLayout(*ground);
  ASSERT_TRUE(CheckLayout(*ground, *layout).none());
  for (const FleetMode mode : {FleetMode::kStraightConcurrent, FleetMode::kStraightSequential,
                               FleetMode::kBentConcurrent, FleetMode::kBentSequential}) {
    const auto plan = PlanOf(scene, {.mode = mode});
    ASSERT_TRUE(plan);
    const auto played = Play(*ground, *layout, plan->schedule, PassingsToKeep(*plan));
    ASSERT_TRUE(played);
    EXPECT_TRUE(played->matches()) << ToString(mode);
  }
}

TEST(PlanFleet, RefusesStartsOffAPathByRounding) {
  // (0.35, 0.35) is on the way from (0.45, 0.75) to (0.3, 0.15) but for rounding.
  const auto fleet = [](double beside) {
    return FleetOf({{{0.45, 0.75}, {0.30000000000000004, 0.15000000000000002}},
                    {{0.35000000000000003 + beside, 0.35000000000000003}, {0.35000000000000003, 0.85000000000000009}}});
  };
  const auto plan = PlanOf(fleet(0));
  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().obstruction, FleetPlanObstruction::kRobotsMeet);
  EXPECT_TRUE(PlanOf(fleet(-1e-9)));
}

TEST(PlanFleet, RobotsKeepTheGapThatIsAskedForAtCrossings) {
  const Scene scene = FleetOf({{{0, 0}, {5.5, 5}, {10, 1}}, {{5, -5}, {5.5, 5}}});
  for (const double gap : {0.1, 0.5, 1.0, 2.0}) {
    const auto plan = PlanOf(scene, {.gap = gap});
    ASSERT_TRUE(plan);
    double least = HUGE_VAL;
    constexpr int kSamples = 20000;
    for (int i = 0; i <= kSamples; ++i) {
      const double t = plan->travel_time * i / kSamples;
      least = std::min(least, Distance(PositionAt(plan->schedule[0], t), PositionAt(plan->schedule[1], t)));
    }
    EXPECT_GE(least, gap - 1e-9);
    EXPECT_NEAR(plan->passings[0].distance, least, 2 * plan->travel_time / kSamples);
    EXPECT_LE(plan->passings[0].distance, least + 1e-12);
  }
}

TEST(PlanFleet, SaysWhoCannotStayThatFarApart) {
  // Each passes before the next one, all around.
  const Scene scene = FleetOf({{{1.2, 4.1}, {4.4, 1.0}, {14.1, 5.4}},
                               {{13.1, 1.0}, {14.1, 5.4}, {5.5, 11.6}},
                               {{9.8, 12.9}, {5.5, 11.6}, {4.4, 1.0}}});
  for (const double gap : {20.0, 1e6, 1e300}) {
    const auto plan = PlanOf(scene, {.gap = gap});
    ASSERT_FALSE(plan);
    EXPECT_EQ(plan.error().obstruction, FleetPlanObstruction::kGapTooWide);
    EXPECT_EQ(plan.error().robots, (std::vector{RobotId(0), RobotId(1), RobotId(2)}));
    EXPECT_NEAR(plan.error().largest_gap, 1.827, 1e-3);
  }
}

TEST(PlanFleet, RadiiAddUpToTheGap) {
  Scene scene = FleetOf({{{0, 0}, {5.5, 5}, {10, 1}}, {{5, -5}, {5.5, 5}}});
  for (FleetRobot& robot : scene.fleet->robots) robot.radius = 0.25;
  const auto plan = PlanOf(scene);
  ASSERT_TRUE(plan);
  EXPECT_GE(plan->passings[0].distance, 0.5 - 1e-12);
  EXPECT_EQ(plan->travel_time, PlanOf(scene, {.gap = 0.5})->travel_time);
}

TEST(PlanFleet, LabelsGoOnAfterZ) {
  EXPECT_EQ(CrossingLabel(0), "A");
  EXPECT_EQ(CrossingLabel(25), "Z");
  EXPECT_EQ(CrossingLabel(26), "AA");
  EXPECT_EQ(CrossingLabel(26 * 27), "AAA");
}

/// Whether a choice of robots, by bits, leaves neither a circle nor a pair.
bool Resolves(const OrderGraph& graph, const std::vector<PairDeadlock>& pairs, unsigned choice) {
  std::vector<bool> gone;
  for (std::size_t i = 0; i < 32; ++i) gone.push_back((choice >> i & 1) != 0);
  for (const PairDeadlock& pair : pairs) {
    if (!gone[pair.a.index()] && !gone[pair.b.index()]) return false;
  }
  return CyclicParts(graph, gone).empty();
}

TEST(Detours, FewestAndShortestOfAllSubsets) {
  Rng rng(7);
  int with_detours = 0;
  const std::int64_t count = ScaledTestCount(400);
  for (std::int64_t trial = 0; trial < count; ++trial) {
    const int robots = rng.UniformInt(3, 9), events = rng.UniformInt(1, 3);
    OrderGraph graph;
    for (int i = 0; i < robots * events; ++i) {
      graph.robot_of.emplace_back(i / events);
      graph.after.emplace_back();
      if (i % events != 0) graph.after[static_cast<std::size_t>(i - 1)].push_back(static_cast<std::uint32_t>(i));
    }
    for (int k = rng.UniformInt(0, 2 * robots * events); k > 0; --k) {
      const int p = rng.UniformInt(0, robots * events - 1), q = rng.UniformInt(0, robots * events - 1);
      if (p / events != q / events) graph.after[static_cast<std::size_t>(p)].push_back(static_cast<std::uint32_t>(q));
    }
    std::vector<PairDeadlock> pairs;
    if (trial % 3 == 0) pairs.push_back({RobotId(0), RobotId(1)});
    std::vector<double> costs;
    for (int i = 0; i < robots; ++i) costs.push_back(rng.UniformInt(0, 8));
    std::pair<int, double> best{robots + 1, 0};
    for (unsigned choice = 0; choice < 1U << robots; ++choice) {
      std::pair<int, double> price{0, 0};
      for (int i = 0; i < robots; ++i) {
        if ((choice >> i & 1) == 0) continue;
        price.first += 1;
        price.second += costs[static_cast<std::size_t>(i)];
      }
      if (price < best && Resolves(graph, pairs, choice)) best = price;
    }
    const std::vector<std::vector<RobotId>> entangled;
    const Detours found = LeastDetours({graph, pairs, entangled, costs});
    double cost = 0;
    unsigned choice = 0;
    for (const RobotId robot : found.robots) {
      cost += costs[robot.index()];
      choice |= 1U << robot.index();
    }
    ASSERT_TRUE(Resolves(graph, pairs, choice)) << trial;
    EXPECT_TRUE(found.optimal);
    EXPECT_EQ(static_cast<int>(found.robots.size()), best.first) << trial;
    EXPECT_EQ(cost, best.second) << trial;
    with_detours += best.first > 1;
    // Without any search, a choice that will do and a bound that holds.
    const Detours quick = LeastDetours({graph, pairs, entangled, costs}, {.nodes = 0});
    choice = 0;
    for (const RobotId robot : quick.robots) choice |= 1U << robot.index();
    ASSERT_TRUE(Resolves(graph, pairs, choice)) << trial;
    EXPECT_LE(static_cast<int>(quick.bound), best.first) << trial;
  }
  EXPECT_GE(with_detours, count / 8);
}

}  // namespace
}  // namespace tautline
