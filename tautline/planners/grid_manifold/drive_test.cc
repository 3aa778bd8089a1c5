#include "tautline/planners/grid_manifold/drive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tautline/base/double_bits.h"
#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/planners/grid_manifold/drive_trace.h"
#include "tautline/planners/grid_manifold/sketched_hall.h"

namespace tautline {
namespace {

DriveOptions With(DriveController controller, Untangling untangle = Untangling::kBoth) {
  return {.controller = controller, .robot = {}, .untangle = untangle};
}

Hall EmptyHall() { return Hall({3, 2}, {}, {.base = {0.25, 1.05}, .length = 4}); }

Hall HallWithPillar() { return Hall({4, 3}, {{{1.7, 1.2}, {2.3, 1.8}}}, {.base = {0.25, 1.45}, .length = 6}); }

std::vector<DriveFailure> FailuresOf(const DriveResult& result) {
  std::vector<DriveFailure> failures;
  for (const GoalOutcome& goal : result.goals) failures.push_back(goal.failure);
  return failures;
}

std::ptrdiff_t Visited(const DriveResult& result) {
  const std::vector<DriveFailure> failures = FailuresOf(result);
  return std::count(failures.begin(), failures.end(), DriveFailure::kNone);
}

TEST(StartDrive, PutsTheRobotInTheMiddleOfItsCell) {
  const Hall hall({3, 2}, {}, {.base = {0.22, 1.07}, .length = 4, .laid = Polyline{{0.22, 1.07}, {1.21, 0.58}}});
  const DriveState state = hall.Start();
  EXPECT_NEAR(state.cable.robot().x, 1.25, 1e-9);
  EXPECT_NEAR(state.cable.robot().y, 0.55, 1e-9);
  EXPECT_EQ(hall.manifold->CellOf(state.at), (GridCell{12, 5}));
}

TEST(StartDrive, FindsTheClassOfTheLaidCable) {
  const Polyline above{{0.25, 1.45}, {2, 2.4}, {3.5, 1.5}}, below{{0.25, 1.45}, {2, 0.5}, {3.5, 1.5}};
  for (const Polyline& laid : {above, below}) {
    const Hall hall({4, 3}, {{{1.7, 1.2}, {2.3, 1.8}}}, {.base = {0.25, 1.45}, .length = 6, .laid = laid});
    EXPECT_EQ(hall.manifold->WordOf(hall.Start().at).empty(), laid == below) << "the ray of the pillar runs upwards";
  }
}

TEST(StartDrive, RefusesWhatCannotLie) {
  const auto reason = [](const Tether& tether) {
    const Hall hall({4, 3}, {{{1.7, 1.2}, {2.3, 1.8}}}, tether);
    return StartDrive(*hall.manifold, *hall.space, tether, {}).error().reason;
  };
  EXPECT_EQ(reason({.base = {0.25, 1.45}, .length = 6, .laid = Polyline{{0.25, 1.45}, {3.5, 1.45}}}),
            "laid_cable_blocked");
  EXPECT_EQ(reason({.base = {0.25, 1.45}, .length = 2, .laid = Polyline{{0.25, 1.45}, {2, 2.4}, {3.5, 1.5}}}),
            "laid_cable_too_long");
  EXPECT_EQ(reason({.base = {0.25, 1.45}, .length = 0}), "tether_too_short");
}

TEST(Drive, GoesStraightWhereNothingIsInTheWay) {
  const Hall hall = EmptyHall();
  for (const DriveController controller :
       {DriveController::kBasic, DriveController::kExtended, DriveController::kRetract}) {
    const DriveResult result = hall.Run({{2.55, 1.05}}, With(controller));
    ASSERT_TRUE(result.Succeeded());
    EXPECT_EQ(result.goals[0].targets, 0);
    EXPECT_EQ(result.RobotContacts(), 0U);
    // Until the robot is as near as it is wide: three cells.
    EXPECT_NEAR(result.end.cable.robot().x, 2.25, 1e-9);
    EXPECT_NEAR(result.goals[0].time_s, 2.0 / 0.3, 1e-6);
  }
}

TEST(Drive, BasicDrivesBackOverItsCable) {
  const DriveResult result = EmptyHall().Run({{2.55, 1.05}, {0.65, 1.05}}, With(DriveController::kBasic));
  EXPECT_TRUE(result.Succeeded());
  EXPECT_EQ(result.RobotContacts(), 1U);
}

TEST(Drive, ExtendedTurnsRoundInsteadOfDrivingOverItsCable) {
  const DriveResult result = EmptyHall().Run({{2.55, 1.05}, {0.65, 1.55}}, With(DriveController::kExtended));
  EXPECT_TRUE(result.Succeeded());
  EXPECT_EQ(result.RobotContacts(), 0U);
}

TEST(Drive, SearchesWhereTheHeuristicFails) {
  const Hall hall({{{1.7, 2.05}, 0.25}, {{2.6, 0.95}, 0.25}, {{3.7, 2.0}, 0.25}}, 7);
  const std::vector<Point> goals{{4.45, 2.55}, {2.65, 2.35}, {4.45, 0.45}};
  DriveOptions with_heuristic = With(DriveController::kExtended, Untangling::kHeuristic);
  with_heuristic.lookahead = false;
  const auto heuristic = hall.Run(goals, with_heuristic);
  EXPECT_THAT(FailuresOf(heuristic),
              testing::ElementsAre(DriveFailure::kNone, DriveFailure::kNone, DriveFailure::kWayNotFound));
  EXPECT_EQ(heuristic.end.cable.time_s(), heuristic.goals[1].time_s) << "what does not lead there is not driven";
  DriveOptions with_search = With(DriveController::kExtended);
  with_search.search_trials = 200;
  with_search.lookahead = false;
  const DriveResult both = hall.Run(goals, with_search);
  EXPECT_TRUE(both.Succeeded());
  EXPECT_TRUE(both.goals[2].searched);
  EXPECT_GT(both.goals[2].targets, 1);
  EXPECT_EQ(both.RobotContacts(), 0U);
}

/// Without lookahead the robot comes back between its cable and the wall, where the cable then locks it in.
TEST(Drive, LooksAheadToGoalsAfterTheNext) {
  const Hall hall({{{2.5, 1.5}, 0.2}}, 5.5);
  const std::vector<Point> goals{{2.65, 0.45}, {1.05, 2.55}, {1.05, 0.45}, {2.45, 2.55}};
  DriveOptions options = With(DriveController::kExtended, Untangling::kHeuristic);
  options.lookahead = false;
  const DriveResult careless = hall.Run(goals, options);
  EXPECT_EQ(careless.goals.back().failure, DriveFailure::kWayNotFound);
  options.lookahead = true;
  const DriveResult careful = hall.Run(goals, options);
  EXPECT_TRUE(careful.Succeeded());
  EXPECT_TRUE(careful.goals.back().thought_again);
  EXPECT_NE(careful.goals[2].time_s, careless.goals[2].time_s) << "another visit before it";
  EXPECT_EQ(careful.RobotContacts(), 0U);
  options.lookahead_trials = 1;
  const DriveResult hasty = hall.Run(goals, options);
  EXPECT_EQ(FailuresOf(hasty), FailuresOf(careless)) << "no trials to look ahead with";
}

TEST(Drive, UntanglesOnceAndTwice) {
  const Hall two({{{1.75, 1.75}, 0.15}, {{3.3, 1.2}, 0.15}}, 5.5), one({{{2.5, 1.5}, 0.2}}, 5.5);
  const DriveOptions heuristic = With(DriveController::kExtended, Untangling::kHeuristic);
  const DriveResult once = two.Run({{2.65, 0.55}, {1.05, 2.55}, {1.05, 0.45}, {2.65, 2.45}}, heuristic);
  EXPECT_TRUE(once.Succeeded());
  EXPECT_EQ(once.goals.back().targets, 1);
  EXPECT_EQ(once.RobotContacts(), 0U);
  const DriveResult twice = one.Run({{2.45, 2.55}, {1.05, 0.45}, {2.65, 0.45}, {4.55, 2.55}, {1.05, 2.55}}, heuristic);
  EXPECT_TRUE(twice.Succeeded());
  EXPECT_EQ(twice.goals.back().targets, 2);
  EXPECT_EQ(twice.RobotContacts(), 0U);
}

TEST(Drive, RetractsUntilTheWayIsOpen) {
  const Hall hall = HallWithPillar();
  const std::vector<Point> goals{{3.45, 1.95}, {3.45, 0.95}, {0.45, 0.45}, {2.05, 2.65}};
  const DriveResult result = hall.Run(goals, With(DriveController::kRetract));
  EXPECT_THAT(FailuresOf(result), testing::Each(DriveFailure::kNone));
  EXPECT_EQ(result.RobotContacts(), 0U);
  EXPECT_NEAR(result.end.cable.SlackM(), 0, 1e-6);
}

TEST(Drive, SaysWhyAGoalIsNotVisited) {
  const Hall hall({4, 3}, {{{1.7, 1.2}, {2.3, 1.8}}}, {.base = {0.25, 1.45}, .length = 3});
  const DriveOptions options = With(DriveController::kExtended);
  EXPECT_THAT(FailuresOf(hall.Run({{0.65, 1.45}, {2, 1.5}, {0.45, 2.45}}, options)),
              testing::ElementsAre(DriveFailure::kNone, DriveFailure::kGoalBlocked, DriveFailure::kNotTried));
  EXPECT_THAT(FailuresOf(hall.Run({{3.85, 2.85}}, options)), testing::ElementsAre(DriveFailure::kTetherTooShort));
  DriveOptions hurried = With(DriveController::kBasic);
  hurried.robot.time_limit_s = 1;
  EXPECT_THAT(FailuresOf(hall.Run({{2.05, 2.65}}, hurried)), testing::ElementsAre(DriveFailure::kTimeUp));
}

TEST(Drive, KeepsOutOfDeadlocksExceptForGoalsInThem) {
  const Hall hall = HallWithPillar();
  DriveOptions options = With(DriveController::kExtended);
  // All ways above the pillar are closed.
  for (int row = 18; row < 30; ++row) {
    for (const ManifoldVertex v : hall.manifold->VerticesAt({20, row})) Insert(*hall.manifold, v, options.deadlocks);
  }
  const DriveResult round = hall.Run({{3.45, 1.85}}, options);
  EXPECT_TRUE(round.Succeeded());
  for (const ManifoldVertex v : round.end.way) EXPECT_FALSE(Contains(options.deadlocks, v));
  EXPECT_FALSE(round.goals[0].deadlocks_entered);
  // Every vertex within the width of the robot of a goal above it is closed.
  for (int column = 14; column < 28; ++column) {
    for (int row = 18; row < 30; ++row) {
      for (const ManifoldVertex v : hall.manifold->VerticesAt({column, row})) {
        Insert(*hall.manifold, v, options.deadlocks);
      }
    }
  }
  const DriveResult into = hall.Run({{2.05, 2.45}}, options);
  EXPECT_TRUE(into.Succeeded());
  EXPECT_TRUE(into.goals[0].deadlocks_entered);
}

TEST(TraceDrive, TakesSamplesOfTheSameDrive) {
  const Hall hall = HallWithPillar();
  const DriveOptions options = With(DriveController::kExtended);
  const std::vector<Point> goals{{3.45, 1.45}, {0.45, 0.45}};
  const DriveState start = hall.Start(options);
  const DriveResult result = Drive(*hall.manifold, start, goals, options);
  const std::vector<DriveFrame> frames = TraceDrive(*hall.manifold, start, result, options.robot, {.sample_s = 0.5});
  EXPECT_EQ(frames.front().t_s, start.cable.time_s());
  EXPECT_EQ(frames.back().t_s, result.end.cable.time_s());
  EXPECT_NEAR(static_cast<double>(frames.size()), 2 + result.end.cable.time_s() / 0.5,
              4 + result.end.cable.time_s() / 10);
  for (const DriveFrame& frame : frames) EXPECT_EQ(frame.cable.back(), frame.robot);
}

/// Random halls with random goals; what every drive must keep.
TEST(Drive, KeepsItsPromisesInRandomHalls) {
  Rng rng(11);
  int blocked = 0, locked = 0;
  const int trials = ScaledTestCount(20);
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<Box> pillars;
    for (int i = rng.UniformInt(1, 2); i > 0; --i) {
      const Point low{0.1 * rng.UniformInt(8, 18), 0.1 * rng.UniformInt(4, 12)};
      pillars.push_back({low, low + Point{0.1 * rng.UniformInt(2, 6), 0.1 * rng.UniformInt(2, 6)}});
    }
    const Hall hall({3, 2}, pillars, {.base = {0.25, 0.95}, .length = rng.Uniform(3, 5)});
    std::vector<Point> goals;
    while (goals.size() < 8) {
      const GridCell cell{rng.UniformInt(2, 27), rng.UniformInt(2, 17)};
      const auto vertices = hall.manifold->VerticesAt(cell);
      if (!vertices.empty()) goals.push_back(hall.ground().CentreOf(cell));
    }
    const DriveResult basic = hall.Run(goals, With(DriveController::kBasic));
    EXPECT_TRUE(basic.Succeeded()) << "the tether reaches all of them, trial " << trial;
    DriveOptions options = With(DriveController::kExtended, Untangling::kHeuristic);
    options.max_targets = 4;
    options.lookahead = false;
    const DriveResult careless = hall.Run(goals, options);
    options.lookahead = true;
    options.lookahead_trials = 60;
    const DriveResult extended = hall.Run(goals, options);
    EXPECT_EQ(extended.RobotContacts() + careless.RobotContacts(), 0U) << "trial " << trial;
    EXPECT_GE(Visited(extended), Visited(careless)) << "trial " << trial;
    if (!careless.Succeeded()) ++locked;
    if (!extended.Succeeded()) ++blocked;
    for (const DriveResult* result : {&basic, &extended, &careless}) {
      EXPECT_LE(result->end.cable.paid_out_m(), hall.scene.tether->length + 1e-6);
      EXPECT_EQ(result->end.cable.robot(), hall.ground().CentreOf(hall.manifold->CellOf(result->end.at)));
      for (const GoalOutcome& goal : result->goals) {
        EXPECT_TRUE(goal.failure != DriveFailure::kNone || goal.time_s > 0);
      }
    }
  }
  std::printf("%d of %d halls locked a robot in, with lookahead %d\n", locked, trials, blocked);
  EXPECT_LE(blocked, 1 + trials / 10);
}

/// One number for all of a drive: where nodes lie, what touched, which way.
std::uint64_t HashOf(const GridManifold& manifold, const DriveResult& result) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  const auto add = [&](std::uint64_t word) { hash = (hash ^ word) * 0x100000001b3ULL; };
  for (const Place& node : result.end.cable.nodes()) {
    add(DoubleBits(node.point.x));
    add(DoubleBits(node.point.y));
  }
  for (const ManifoldVertex v : result.end.way) {
    const GridCell cell = manifold.CellOf(v);
    add(static_cast<std::uint64_t>(cell.row) << 32 | static_cast<std::uint64_t>(cell.column));
  }
  add(result.end.cable.contacts().size());
  return hash;
}

TEST(Drive, IsTheSameEveryTime) {
  const Hall hall = HallWithPillar();
  const std::vector<Point> goals{{3.45, 1.45}, {0.45, 0.45}, {2.05, 2.65}};
  const DriveOptions options = With(DriveController::kExtended);
  const std::uint64_t hash = HashOf(*hall.manifold, hall.Run(goals, options));
  EXPECT_EQ(hash, HashOf(*hall.manifold, HallWithPillar().Run(goals, options)));
  EXPECT_EQ(hash, 0xd47b68ecc3ea6b57U) << std::hex << hash;
}

}  // namespace
}  // namespace tautline
