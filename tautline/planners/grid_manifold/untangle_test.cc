#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tautline/planners/grid_manifold/sketched_hall.h"
#include "tautline/planners/grid_manifold/state_key.h"
#include "tautline/planners/grid_manifold/untangle_search.h"

namespace tautline {
namespace {

/// A drive with the extended controller, ready to be asked about one goal.
struct Case {
  Hall hall;
  DriveOptions options;
  RobotDriver driver;
  DriveState state;

  Case(Hall a_hall, const std::vector<Point>& before)
      : hall(std::move(a_hall)), driver(*hall.manifold, {}, {}), state(hall.Run(before, options).end) {}

  ManifoldGoalField FieldTo(Point goal) const { return {*hall.manifold, *hall.ground().CellAt(goal)}; }
};

/// The robot's own cable lies around it.
Case Crossed() {
  return {Hall({{{1.7, 2.05}, 0.25}, {{2.6, 0.95}, 0.25}, {{3.7, 2.0}, 0.25}}, 7), {{4.45, 2.55}, {2.65, 2.35}}};
}

TEST(TryTarget, LeavesTheStateAsItWas) {
  Case c = Crossed();
  const Point goal{4.45, 0.45};
  const ManifoldGoalField field = c.FieldTo(goal);
  TrialBudget budget;
  const GoalVisit visit(c.driver, goal, field, budget);
  const std::uint64_t before = StateKey(c.state, 1e-6);
  const ManifoldVertex target = *c.hall.manifold->Step(c.state.at, 4);
  TryTarget(c.driver, visit, c.state, target);
  EXPECT_EQ(StateKey(c.state, 1e-6), before);
}

TEST(GoalVisit, AnOpenWayIsNotBlockedAnywhere) {
  Case c = Crossed();
  const ManifoldGoalField back = c.FieldTo({2.65, 2.35});
  TrialBudget budget;
  const GoalVisit visit(c.driver, {2.65, 2.35}, back, budget);
  EXPECT_TRUE(visit.IsWayOpen(c.state));
  EXPECT_EQ(visit.CountBlockedPlaces(c.state), 0) << "it is there";
  EXPECT_TRUE(visit.Try(c.state));
}

TEST(StateKey, TellsCablesAndVerticesApart) {
  Case c = Crossed();
  DriveState moved = c.state;
  EXPECT_EQ(StateKey(moved, 0.34), StateKey(c.state, 0.34));
  const ManifoldVertex beside = *c.hall.manifold->Step(moved.at, 4);
  c.driver.StepTo(beside, moved);
  EXPECT_NE(StateKey(moved, 0.34), StateKey(c.state, 0.34));
}

TEST(SearchUntangling, NeverDoesWorseWithMoreTrials) {
  Case c = Crossed();
  const Point goal{4.45, 0.45};
  const ManifoldGoalField field = c.FieldTo(goal);
  TrialBudget budget;
  const GoalVisit visit(c.driver, goal, field, budget);
  EXPECT_FALSE(visit.IsWayOpen(c.state));
  EXPECT_GE(visit.CountBlockedPlaces(c.state), 1);
  double least = std::numeric_limits<double>::infinity();
  bool found = false;
  for (const int trials : {5, 50, 200}) {
    const UntangleResult result = SearchUntangling(c.driver, visit, c.state, {.max_trials = trials});
    EXPECT_LE(result.trials, trials);
    if (!result.visited) {
      EXPECT_FALSE(found);
      continue;
    }
    found = true;
    EXPECT_LE(result.visited->cable.time_s(), least);
    least = result.visited->cable.time_s();
    EXPECT_TRUE(visit.destination().holds(result.visited->at));
  }
  EXPECT_TRUE(found);
}

/// The goal is behind a slit that the robot's own cable fills: whatever it does there, the cable lies in the slit.
TEST(SearchUntangling, SaysThatThereIsNoWay) {
  // A corridor as wide as three robots: the cable in its middle leaves no room beside.
  Hall hall({2.4, 0.3}, {}, {.base = {0.15, 0.15}, .length = 3});
  Case c(std::move(hall), {{2.25, 0.15}});
  const Point goal{0.75, 0.15};
  const ManifoldGoalField field = c.FieldTo(goal);
  TrialBudget budget;
  const GoalVisit visit(c.driver, goal, field, budget);
  EXPECT_FALSE(visit.IsWayOpen(c.state));
  const UntangleResult result = SearchUntangling(c.driver, visit, c.state, {.max_trials = 1000});
  EXPECT_FALSE(result.visited);
  EXPECT_TRUE(result.exhausted);
  EXPECT_LT(result.trials, 1000);
}

TEST(GoalVisit, SeesThatTheRetreatIsLost) {
  // At the end of a narrow corridor the robot cannot turn; at its base it need not.
  const Hall hall({2.4, 0.3}, {}, {.base = {0.15, 0.15}, .length = 3});
  RobotDriver driver(*hall.manifold, {}, {});
  const Point goal{2.25, 0.15};
  const ManifoldGoalField field(*hall.manifold, *hall.ground().CellAt(goal));
  TrialBudget budget;
  const GoalVisit careless(driver, goal, field, budget), careful(driver, goal, field, budget, {.keep_retreat = true});
  const DriveState start = hall.Start();
  EXPECT_TRUE(careful.KeepsRetreat(start));
  const auto visited = careless.Try(start);
  ASSERT_TRUE(visited);
  EXPECT_FALSE(careful.KeepsRetreat(*visited));
  EXPECT_FALSE(careful.Try(start));
}

TEST(Drive, SaysWhereThereIsNoWayBack) {
  const Hall hall({2.4, 0.3}, {}, {.base = {0.15, 0.15}, .length = 3});
  DriveOptions options;
  options.keep_retreat = true;
  options.search_trials = 50;
  const DriveResult result = hall.Run({{2.25, 0.15}}, options);
  ASSERT_TRUE(result.Succeeded());
  EXPECT_FALSE(result.goals[0].retreat_kept);
}

}  // namespace
}  // namespace tautline
