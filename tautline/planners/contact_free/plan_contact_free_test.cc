#include "tautline/planners/contact_free/plan_contact_free.h"

#include <gtest/gtest.h>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/planners/contact_free/motion_faults.h"
#include "tautline/planners/contact_free/track_path.h"

namespace tautline {
namespace {

Ring Rectangle(double x, double y, double w, double h) { return {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}; }

Scene SceneOf(const std::vector<Ring>& rectangles, const Tether& tether, Point goal) {
  Scene scene{.world = {.outline = Rectangle(0, 0, 12, 12)}, .tether = tether, .goal = goal};
  for (const Ring& ring : rectangles) scene.world.obstacles.push_back({.polygon = PolygonWithHoles{ring, {}}});
  return scene;
}

ContactFreeResult Plan(const Scene& scene, const ContactFreeOptions& options = {}) {
  auto result = PlanContactFree(scene, options);
  EXPECT_TRUE(result) << ToString(result.error());
  return *std::move(result);
}

/// The costs of a result against the environment itself, step by step.
void ExpectReplayed(const Scene& scene, const ContactFreeResult& result) {
  ASSERT_EQ(result.status, ContactFreeStatus::kSolved);
  EXPECT_EQ(MotionFaults(scene, result, {}), std::vector<std::string>{});
}

TEST(MotionFaults, SayWhatIsNotAsClaimed) {
  const Scene scene = SceneOf({Rectangle(4, 0, 2, 7)}, {.base = {2, 5}, .length = 20}, {8.5, 4});
  const ContactFreeResult right = Plan(scene);
  ExpectReplayed(scene, right);
  const auto faults_of = [&](const auto& spoil) {
    ContactFreeResult wrong = right;
    spoil(wrong);
    return MotionFaults(scene, wrong, {}).size();
  };
  EXPECT_GE(faults_of([](ContactFreeResult& r) { r.motion.velocities.pop_back(); }), 2);
  EXPECT_GE(faults_of([](ContactFreeResult& r) { r.motion.velocities.push_back({1, 0}); }), 1);
  EXPECT_GE(faults_of([](ContactFreeResult& r) { r.motion.poses.front().heading_rad += 1; }), 1);
  EXPECT_EQ(faults_of([](ContactFreeResult& r) { ++r.motion.costs.cable_robot_steps; }), 1);
  EXPECT_EQ(faults_of([](ContactFreeResult& r) { ++r.motion.costs.cable_obstacle_steps; }), 1);
  EXPECT_EQ(faults_of([](ContactFreeResult& r) { r.cost += 0.01; }), 1);
  EXPECT_EQ(faults_of([](ContactFreeResult& r) { r.bound = r.cost + 1; }), 1);
}

TEST(PlanContactFree, KeepsTheCableOffACorner) {
  // Close around the block's corner the cable would be drawn onto it.
  const Scene scene = SceneOf({Rectangle(4, 0, 2, 7)}, {.base = {2, 5}, .length = 20}, {8.5, 4});
  const ContactFreeResult result = Plan(scene);
  ASSERT_EQ(result.status, ContactFreeStatus::kSolved) << result.explanation;
  ExpectReplayed(scene, result);
  EXPECT_TRUE(result.contacts_proved());
  EXPECT_LT(result.motion.costs.length_m, 1.5 * result.shortest_m);
  EXPECT_GT(result.tether.length, Distance({2, 5}, {8.5, 4}));
}

TEST(PlanContactFree, ItsPathIsOneToTrack) {
  const Scene scene = SceneOf({Rectangle(4, 0, 2, 7)}, {.base = {2, 5}, .length = 20}, {8.5, 4});
  const ContactFreeResult result = Plan(scene);
  const FreeSpace space = BuildFreeSpace(scene.world).value();
  const ContactMap map(space, 0.1);
  TetherTask task = TaskOf(scene).value();
  task.heading_rad = result.motion.poses.front().heading_rad;
  const TrackResult track = TrackPath(TetherEnv::Create(map, task, result.env).value(), result.path);
  EXPECT_TRUE(track.success());
  EXPECT_EQ(track.cable_obstacle_steps + track.cable_robot_steps, 0);
  EXPECT_NEAR(track.driven_m, result.motion.costs.length_m, 1e-6);
}

TEST(PlanContactFree, TurnsBackWithoutDrivingOverItsCable) {
  const Scene scene = SceneOf({Rectangle(5, 4.5, 1, 1)},
                              {.base = {2, 4}, .length = 25, .laid = Polyline{{2, 4}, {5.5, 4}, {9, 6}}}, {2, 7});
  const ContactFreeResult result = Plan(scene);
  ASSERT_EQ(result.status, ContactFreeStatus::kSolved) << result.explanation;
  ExpectReplayed(scene, result);
  EXPECT_TRUE(result.contacts_proved());
}

TEST(PlanContactFree, GivesTheSameAnswerTwice) {
  const Scene scene = SceneOf({Rectangle(4, 4, 1, 1), Rectangle(7, 6, 1, 1)}, {.base = {2, 2}, .length = 20}, {10, 9});
  const ContactFreeResult a = Plan(scene), b = Plan(scene);
  EXPECT_EQ(a.motion.velocities, b.motion.velocities);
  EXPECT_EQ(a.path, b.path);
}

TEST(PlanContactFree, ProvesWhatCannotBe) {
  const std::vector<Ring> wall = {Rectangle(5, 0, 1, 12)}, gap = {Rectangle(5, 0, 1, 5.6), Rectangle(5, 6.5, 1, 5.5)};
  const Tether tether{.base = {2, 6}, .length = 20};
  const auto reason = [](const Scene& scene) {
    const ContactFreeResult result = Plan(scene);
    EXPECT_EQ(result.status, ContactFreeStatus::kInfeasible);
    EXPECT_FALSE(result.explanation.empty());
    return result.reason;
  };
  EXPECT_EQ(reason(SceneOf(wall, tether, {9, 6})), "goal_unreachable");
  EXPECT_EQ(reason(SceneOf(gap, tether, {9, 6})), "goal_unreachable");
  EXPECT_EQ(reason(SceneOf(wall, tether, {4.8, 6})), "goal_blocked");
  EXPECT_EQ(reason(SceneOf(wall, tether, {20, 6})), "goal_blocked");
  EXPECT_EQ(reason(SceneOf(wall, {.base = {4.6, 6}, .length = 20}, {2, 2})), "start_blocked");
  EXPECT_EQ(reason(SceneOf({}, {.base = {2, 6}, .length = 4}, {9, 6})), "tether_too_short");
  EXPECT_EQ(reason(SceneOf({}, {.base = {2, 6}, .length = 4, .laid = Polyline{{2, 6}, {7, 6}}}, {3, 3})),
            "laid_cable_too_long");
  EXPECT_EQ(
      reason(SceneOf({Rectangle(5, 5, 1, 2)}, {.base = {2, 6}, .length = 9, .laid = Polyline{{2, 6}, {9, 6}}}, {3, 3})),
      "laid_cable_blocked");
}

TEST(PlanContactFree, CountsWhatTheRobotSparesOfTheTether) {
  // The goal is 6 m away; within half a metre of it, with the tail half a metre behind, 5 m of cable suffice.
  const Scene scene = SceneOf({}, {.base = {2, 6}, .length = 5.1}, {8, 6});
  EXPECT_EQ(Plan(scene).status, ContactFreeStatus::kSolved);
}

TEST(PlanContactFree, GoesOnWhereAllCableIsOut) {
  // The laid cable goes on to the robot's centre, half a metre beyond the cable's end.
  const Polyline laid{{2, 6}, {4, 8}, {6, 6}};
  const auto status = [&](double spare_m) {
    return Plan(SceneOf({}, {.base = {2, 6}, .length = Length(laid) - 0.5 + spare_m, .laid = laid}, {5, 3})).status;
  };
  EXPECT_EQ(status(1e-6), ContactFreeStatus::kSolved);
  EXPECT_EQ(status(-1e-6), ContactFreeStatus::kInfeasible);
}

TEST(PlanContactFree, StopsWhenTold) {
  const Scene scene = SceneOf({Rectangle(4, 0, 2, 7)}, {.base = {2, 5}, .length = 20}, {8.5, 4});
  const ContactFreeResult result = Plan(scene, {.watch = [](std::string_view, double) { return false; }});
  EXPECT_EQ(result.status, ContactFreeStatus::kBudgetExceeded);
  EXPECT_EQ(result.reason, "budget_exceeded");
}

TEST(PlanContactFree, KeepsItsBudget) {
  const Scene scene = SceneOf({Rectangle(4, 0, 2, 7)}, {.base = {2, 5}, .length = 20}, {8.5, 4});
  const std::int64_t enough = Plan(scene).expansions;
  for (const std::int64_t budget : {std::int64_t{1}, std::int64_t{50}, enough - 1}) {
    EXPECT_EQ(Plan(scene, {.budget = budget}).expansions, budget);
  }
  EXPECT_EQ(Plan(scene, {.budget = 1}).reason, "budget_exceeded");
  EXPECT_EQ(Plan(scene, {.budget = 10 * enough}).expansions, enough);
  // A search that has begun goes on: the first one finds what there is.
  EXPECT_EQ(Plan(scene, {.last_search = 1}).status, ContactFreeStatus::kSolved);
}

TEST(PlanContactFree, SaysWhatIsMissing) {
  EXPECT_FALSE(PlanContactFree(Scene{.world = {.outline = Rectangle(0, 0, 9, 9)}}));
  Scene scene = SceneOf({}, {.base = {2, 6}, .length = 5}, {8, 6});
  scene.goal.reset();
  EXPECT_FALSE(PlanContactFree(scene));
}

TEST(PlanContactFreeRandom, CostsAreThoseOfTheEnvironment) {
  Rng rng(5);
  int solved = 0;
  const int trials = ScaledTestCount(12);
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<Ring> rectangles;
    for (int i = 0; i < 4; ++i) {
      rectangles.push_back(
          Rectangle(rng.Uniform(2.5, 8.5), rng.Uniform(2.5, 8.5), rng.Uniform(0.4, 1.5), rng.Uniform(0.4, 1.5)));
    }
    const Scene scene =
        SceneOf(rectangles, {.base = {1.5, 1.5}, .length = 22}, {rng.Uniform(9.5, 10.8), rng.Uniform(7, 10.8)});
    const ContactFreeResult result = Plan(scene, {.last_search = 3000});
    if (result.status != ContactFreeStatus::kSolved) continue;
    ++solved;
    SCOPED_TRACE(trial);
    ExpectReplayed(scene, result);
  }
  EXPECT_GT(2 * solved, trials);
}

}  // namespace
}  // namespace tautline
