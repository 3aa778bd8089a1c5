#include "tautline/planners/contact_free/contact_free_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"

namespace tautline {
namespace {

Ring Rectangle(double x, double y, double w, double h) { return {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}; }

/// A small room with a robot of 0.2 m, its cable laid, and what a search needs to know of them.
struct Chamber {
  World world{.outline = Rectangle(0, 0, 4, 4)};
  FreeSpace space;
  std::optional<TautSpace> room;
  std::optional<ContactMap> map;
  std::optional<TetherEnv> env;
  std::optional<GoalGuide> guide;
  std::optional<Rays> rays;

  Chamber(const std::vector<Ring>& rectangles, const TetherTask& task) {
    for (const Ring& ring : rectangles) world.obstacles.push_back({.polygon = PolygonWithHoles{ring, {}}});
    space = BuildFreeSpace(world).value();
    room.emplace(BuildFreeSpace(world, {.clearance = 0.19}).value());
    map.emplace(space, 0.05);
    rays.emplace(space);
    TetherEnvOptions options{.robot_radius_m = 0.2, .link_length_m = 0.4, .goal_radius_m = 0.1};
    options.reward.use_reference = false;
    options.reward.goal = 0;
    if (auto created = TetherEnv::Create(*map, task, options)) env = *std::move(created);
    if (const auto goal = room->Locate(task.goal)) guide.emplace(*room, *goal, 0.02);
  }

  SearchProblem problem() { return {.env = &*env, .guide = &*guide, .rays = &*rays, .costs = {.cable_margin_m = 0}}; }
};

/// All states are told apart and followed.
SearchGrain Exhaustive(int layers) {
  return {.cell_m = 1e-9,
          .headings = 1'000'000'000,
          .shape_m = 1e-9,
          .shape_nodes = 100,
          .primitive_steps = 3,
          .width = 1'000'000,
          .crowd = 1'000'000,
          .layers = layers,
          .patience = 100,
          .slack = 0,
          .risk = 0};
}

/// The least cost over all sequences of primitives, tried one by one; infinite where none leads to the goal.
double LeastCost(const TetherEnv& env, int primitives_left) {
  constexpr double kPerMetre = 0.2;
  double least = std::numeric_limits<double>::infinity();
  if (primitives_left == 0) return least;
  for (const auto& [speed, turn, steps] :
       {std::tuple(1.0, 0.0, 3), std::tuple(1.0, 0.5, 3), std::tuple(1.0, -0.5, 3), std::tuple(1.0, 1.0, 3),
        std::tuple(1.0, -1.0, 3), std::tuple(1.0, 2.0, 3), std::tuple(1.0, -2.0, 3), std::tuple(0.0, 2.0, 1),
        std::tuple(0.0, -2.0, 1)}) {
    TetherEnv driven = env;
    double cost = 0;
    bool refused = false, at_goal = false;
    for (int k = 0; k < steps && !refused && !at_goal; ++k) {
      const EnvStep step = driven.StepWith(speed, turn);
      refused = step.robot_obstacle || step.held;
      at_goal = step.at_goal;
      cost += kPerMetre * 0.1 * speed - step.reward;
    }
    if (refused) continue;
    least = std::min(least, cost + (at_goal ? 0 : LeastCost(driven, primitives_left - 1)));
  }
  return least;
}

TEST(ContactFreeSearch, DrivesStraightOnWhereItCan) {
  Chamber chamber({}, {.laid = {{1, 2}}, .heading_rad = 0, .cable_length_m = 5, .goal = {2.5, 2}});
  const SearchOutcome outcome = SearchMotion(chamber.problem(), {});
  ASSERT_EQ(outcome.end, SearchEnd::kFound);
  EXPECT_EQ(outcome.motions.front(), std::vector<Velocity>(14, {1, 0}));
  EXPECT_NEAR(outcome.cost, 1.4 * 0.2 + 14 * 0.001, 1e-12);
}

TEST(ContactFreeSearch, SaysThatNothingIsLeft) {
  // Wherever the cable lets the robot go, it is still a metre from the goal.
  Chamber chamber({}, {.laid = {{1, 2}}, .heading_rad = 0, .cable_length_m = 0.4, .goal = {2.5, 2}});
  const SearchOutcome outcome = SearchMotion(chamber.problem(), {.layers = 10'000});
  EXPECT_EQ(outcome.end, SearchEnd::kExhausted);
  EXPECT_TRUE(outcome.motions.empty());
  EXPECT_GT(outcome.expansions, 1);
}

TEST(ContactFreeSearch, KeepsItsBudget) {
  Chamber chamber({}, {.laid = {{1, 2}}, .heading_rad = 2, .cable_length_m = 5, .goal = {3, 2}});
  SearchProblem problem = chamber.problem();
  for (const std::int64_t budget : {1, 2, 77}) {
    problem.budget = budget;
    const SearchOutcome outcome = SearchMotion(problem, {});
    EXPECT_EQ(outcome.expansions, budget);
    EXPECT_EQ(outcome.end, SearchEnd::kBudget);
  }
}

TEST(ContactFreeSearch, StopsWhenTold) {
  Chamber chamber({Rectangle(1.5, 0.5, 0.4, 3)}, {.laid = {{1, 2}}, .cable_length_m = 5, .goal = {3, 2}});
  SearchProblem problem = chamber.problem();
  problem.keep_going = [] { return false; };
  EXPECT_EQ(SearchMotion(problem, {}).end, SearchEnd::kBudget);
}

TEST(ContactFreeSearch, NeverPullsTheCableThroughAnObstacle) {
  // The cable lies above the post and the goal is below: straight back would drag it across.
  Chamber chamber({Rectangle(1.8, 1.8, 0.2, 0.4)},
                  {.laid = {{0.5, 2}, {1.9, 2.6}, {3, 2.4}}, .cable_length_m = 8, .goal = {3, 1}});
  const SearchOutcome outcome = SearchMotion(chamber.problem(), {.cell_m = 0.15, .shape_m = 0.2});
  ASSERT_EQ(outcome.end, SearchEnd::kFound);
  for (const std::vector<Velocity>& motion : outcome.motions) {
    const DrivenMotion driven = DriveMotion(*chamber.env, motion);
    Polyline cable = driven.cables.back();
    cable.push_back(driven.poses.back().at);
    Polyline way = chamber.env->task().laid;
    for (const RobotPose& pose : driven.poses) way.push_back(pose.at);
    EXPECT_EQ(chamber.rays->WordOf(cable), chamber.rays->WordOf(way));
  }
}

TEST(ContactFreeSearchRandom, FindsTheBestOfAllMotionsOnTinyProblems) {
  Rng rng(11);
  int found = 0;
  const int trials = ScaledTestCount(25);
  for (int trial = 0; trial < trials; ++trial) {
    const auto at = [&] { return Point{rng.Uniform(0.6, 3.4), rng.Uniform(0.6, 3.4)}; };
    const Point robot = at(), base = robot + Point{rng.Uniform(-0.5, 0.5), rng.Uniform(-0.5, 0.5)};
    const double angle = rng.Uniform(-3, 3), reach = rng.Uniform(0.5, 1.0);
    Chamber chamber({Rectangle(rng.Uniform(0.5, 3), rng.Uniform(0.5, 3), 0.3, 0.3)},
                    {.laid = {base, robot},
                     .heading_rad = angle + rng.Uniform(-1.0, 1.0),
                     .cable_length_m = 2,
                     .goal = robot + reach * Point{std::cos(angle), std::sin(angle)}});
    if (!chamber.env || !chamber.guide || !std::isfinite(chamber.guide->LowerBound(robot))) continue;
    const double least = LeastCost(*chamber.env, 4);
    const SearchOutcome outcome = SearchMotion(chamber.problem(), Exhaustive(4));
    ASSERT_EQ(outcome.end == SearchEnd::kFound, std::isfinite(least)) << "trial " << trial;
    if (outcome.end != SearchEnd::kFound) continue;
    ++found;
    // The search refuses to pull the cable through obstacles; with one so small, that is never better.
    EXPECT_NEAR(outcome.cost, least, 1e-9) << "trial " << trial;
    const DrivenMotion driven = DriveMotion(*chamber.env, outcome.motions.front());
    EXPECT_TRUE(driven.at_goal);
    EXPECT_NEAR(driven.costs.penalty + 0.2 * driven.costs.length_m, outcome.cost, 1e-9);
  }
  EXPECT_GT(found, trials / 5);
}

}  // namespace
}  // namespace tautline
