#include "tautline/planners/tether/reach.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tautline/base/test_scale.h"
#include "tautline/homotopy/sketched_scene.h"
#include "tautline/planners/tether/random_reach.h"
#include "tautline/planners/tether/verify_reach.h"

namespace tautline {
namespace {

constexpr double kPi = std::numbers::pi;

/// A wall with a way over it and a longer way under it; the base is on the left.
SketchedScene Wall() {
  return Sketch({".......",  //
                 "...w...",  //
                 "B..w..G",  //
                 "...w...",  //
                 "...w...",  //
                 "......."});
}

ReachResult ReachOf(const SketchedScene& sketch, double length, const ReachOptions& options = {}) {
  Scene scene;
  scene.world = sketch.world;
  scene.tether = Tether{sketch['B'], length, {}};
  return Reach(scene, options).value();
}

TEST(Reach, TellsAreaAndRing) {
  const ReachResult result = ReachOf(Wall(), 0.4);
  EXPECT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_NEAR(result.area, kPi * 0.16, 1e-14);
  EXPECT_NEAR(result.connected_area, 38, 1e-12);
  ASSERT_EQ(result.regions.size(), 1u);
  EXPECT_FALSE(result.sheets);
  EXPECT_FALSE(result.at);
}

TEST(Reach, AsksAboutAPoint) {
  const auto sketch = Wall();
  const double over = 2 * std::hypot(2.5, 1.5) + 1, under = 2 * std::hypot(2.5, 2.5) + 1;
  const ReachResult near = ReachOf(sketch, over + 0.01, {.at = sketch['G']});
  EXPECT_EQ(near.at->obstruction, PlanObstruction::kNone);
  EXPECT_NEAR(near.at->least_tether->length, over, 1e-12);
  EXPECT_FALSE(near.at->classes);
  const ReachResult both = ReachOf(sketch, under + 0.01, {.sheets = true, .at = sketch['G']});
  EXPECT_EQ(both.at->classes->classes.size(), 2u);
  EXPECT_TRUE(both.at->classes->complete);
  const ReachResult far = ReachOf(sketch, over - 0.01, {.at = sketch['G']});
  EXPECT_EQ(far.status, PlanStatus::kSolved);
  EXPECT_EQ(far.at->obstruction, PlanObstruction::kTetherTooShort);
  EXPECT_NEAR(far.at->least_tether->length, over, 1e-12);
  const ReachResult blocked = ReachOf(sketch, 9, {.at = Point{3.5, 3.5}});
  EXPECT_EQ(blocked.at->obstruction, PlanObstruction::kGoalBlocked);
  EXPECT_FALSE(blocked.at->least_tether);
}

TEST(Reach, PointsOnOtherGroundAreOutOfReach) {
  const auto sketch = Sketch({".w.",  //
                              "BwG",  //
                              ".w."});
  const ReachResult result = ReachOf(sketch, 100, {.at = sketch['G']});
  EXPECT_EQ(result.at->obstruction, PlanObstruction::kGoalUnreachable);
  EXPECT_NEAR(result.area, 3, 1e-12);
  EXPECT_NEAR(result.connected_area, 3, 1e-12);
}

TEST(Reach, TheStubOfASocketCounts) {
  Scene scene;
  scene.world.outline = Rectangle({0, 0}, {20, 20});
  scene.world.clearance = 0.5;
  scene.tether = Tether{{0, 10}, 3.5, {}};
  const ReachResult result = Reach(scene).value();
  EXPECT_NEAR(result.area, 0.5 * kPi * 9, 1e-8);
  scene.tether->length = 0.4;
  const ReachResult inside = Reach(scene).value();
  EXPECT_EQ(inside.status, PlanStatus::kInfeasible);
  EXPECT_EQ(inside.obstruction, PlanObstruction::kTetherTooShort);
}

TEST(Reach, ABlockedBaseReachesNothing) {
  Scene scene;
  scene.world = Wall().world;
  scene.tether = Tether{{3.5, 3.5}, 5, {}};
  const ReachResult result = Reach(scene).value();
  EXPECT_EQ(result.status, PlanStatus::kInfeasible);
  EXPECT_EQ(result.obstruction, PlanObstruction::kStartBlocked);
  EXPECT_FALSE(result.explanation.empty());
  scene.tether.reset();
  EXPECT_FALSE(Reach(scene));
}

TEST(Reach, OutOfBudgetItTellsThePlaneAndALowerBound) {
  const ReachResult all = ReachOf(Wall(), 30, {.sheets = true});
  const ReachResult some = ReachOf(Wall(), 30, {.sheets = true, .budget = 5});
  EXPECT_EQ(all.status, PlanStatus::kSolved);
  EXPECT_EQ(some.status, PlanStatus::kBudgetExceeded);
  EXPECT_FALSE(some.explanation.empty());
  EXPECT_EQ(some.area, all.area);
  EXPECT_LT(some.sheets->area, all.sheets->area);
}

TEST(Reach, GoesWhereAPlanGoes) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(150); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomReach question = MakeRandomReach(rng, seed % 2 == 0, false, 10);
    const TetherPlanner planner = TetherPlanner::Prepare(question.ground.world).value();
    const Tether tether{question.base, question.length, {}};
    for (const Point p : question.samples) {
      const ReachResult result = Reach(planner, tether, {.at = p});
      const PlanResult plan = planner.Plan(tether, p);
      ASSERT_EQ(result.at->obstruction, plan.obstruction);
      if (std::fabs(result.at->least_tether ? result.at->least_tether->length - question.length : 1) < 1e-3) continue;
      ASSERT_EQ(WindingAround(result.regions, p), plan.status == PlanStatus::kSolved ? 1 : 0);
    }
    ASSERT_EQ(VerifyReach(planner, tether, Reach(planner, tether)).faults, std::vector<std::string>());
  }
}

TEST(VerifyReach, FindsFaults) {
  const auto sketch = Wall();
  const TetherPlanner planner = TetherPlanner::Prepare(sketch.world).value();
  const Tether tether{sketch['B'], 4.5, {}};
  const ReachResult right = Reach(planner, tether, {.sheets = true});
  EXPECT_TRUE(VerifyReach(planner, tether, right).faults.empty());
  EXPECT_GT(VerifyReach(planner, tether, right).curves, 0);
  EXPECT_FALSE(VerifyReach(planner, {sketch['B'], 4.6, {}}, right).faults.empty());
  ReachResult wrong = right;
  wrong.area += 0.01;
  EXPECT_FALSE(VerifyReach(planner, tether, wrong).faults.empty());
  wrong = right;
  wrong.regions[0].pieces.pop_back();
  EXPECT_FALSE(VerifyReach(planner, tether, wrong).faults.empty());
  wrong = right;
  wrong.sheets->sheets[0].area *= 1.01;
  EXPECT_FALSE(VerifyReach(planner, tether, wrong).faults.empty());
}

}  // namespace
}  // namespace tautline
