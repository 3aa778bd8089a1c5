#include "tautline/planners/cable_workspace/place.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/homotopy/random_scene.h"

namespace tautline {
namespace {

World Room(double width, double height) {
  World world;
  world.outline = Rectangle({0, 0}, {width, height});
  return world;
}

World Hall() {
  World world = Room(20, 12);
  for (const Point low : {Point{4, 4}, {9, 7}, {14, 3}}) {
    world.obstacles.push_back(random_scene::PolygonObstacle(world, Rectangle(low, low + Point{2, 1.5})));
  }
  return world;
}

World Doubled(World world) {
  for (Point& p : world.outline) p = 2 * p;
  for (Obstacle& obstacle : world.obstacles) {
    for (Point& p : obstacle.polygon->outer) p = 2 * p;
  }
  return world;
}

PlacementGround Prepared(const World& world, const PlacementOptions& options) {
  return PlacementGround::Prepare(world, options).value();
}

std::vector<PlaceJob> RunJobs(const PlacementGround& ground, const PlaceJobOptions& options, std::size_t count) {
  std::vector<PlaceJob> jobs;
  for (std::size_t k = 0; k < count; ++k) jobs.push_back(RunPlaceJob(ground, options, k).value());
  return jobs;
}

TEST(PlaceWinches, FourInAnEmptyRectangleStandInItsCorners) {
  const PlacementGround ground = Prepared(Room(12, 8), {.anchors = 4});
  for (std::size_t job = 0; job < 8; ++job) {
    const auto found = RunPlaceJob(ground, {.evaluations = 400}, job);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->positions, (std::vector<double>{0, 12, 20, 32})) << job;
    EXPECT_EQ(found->gains.back().worth.value, 96) << job;
  }
}

TEST(PlaceWinches, ThreeInAnEmptyRectangleHoldHalfOfIt) {
  const PlacementGround ground = Prepared(Room(12, 8), {.anchors = 3});
  const PlaceResult result = PlaceWinches(ground, {.job = {.evaluations = 200}, .jobs = 4});
  EXPECT_EQ(result.status, PlaceStatus::kSolved);
  EXPECT_NEAR(result.placement->worth.value, 48, 1e-9);
  EXPECT_EQ(result.jobs, 4u);
  EXPECT_EQ(result.incomplete, 0);
}

TEST(PlaceWinches, TheBestNeverFalls) {
  for (const PlaceObjective objective : {PlaceObjective::kArea, PlaceObjective::kCable}) {
    const PlacementGround ground =
        Prepared(Hall(), {.anchors = 4, .objective = objective, .tasks = {{3, 6}, {12, 6}, {10, 3}}});
    const PlaceResult result = PlaceWinches(ground, {.job = {.evaluations = 60}, .jobs = 6});
    ASSERT_EQ(result.status, PlaceStatus::kSolved);
    ASSERT_GE(result.history.size(), 3u);
    for (std::size_t i = 1; i < result.history.size(); ++i) {
      const PlaceRecord &before = result.history[i - 1], &after = result.history[i];
      EXPECT_LT(before.evaluations, after.evaluations);
      EXPECT_LE(before.job, after.job);
      EXPECT_TRUE(ground.IsBetter({0, after.best}, {0, before.best}));
    }
    EXPECT_EQ(result.history.back().best, result.placement->worth.value);
    EXPECT_LE(result.history.back().evaluations, result.evaluations);
    EXPECT_LE(result.evaluations, 6 * 60);
  }
}

TEST(PlaceWinches, AJobDependsOnItsNumberAloneAndJoiningOnNoOrder) {
  const PlacementGround ground = Prepared(Hall(), {.anchors = 4});
  const PlaceJobOptions options{.evaluations = 40, .seed = 7};
  std::vector<PlaceJob> jobs = RunJobs(ground, options, 5);
  EXPECT_EQ(RunPlaceJob(Prepared(Hall(), {.anchors = 4}), options, 3), jobs[3]) << "elsewhere, and without the others";
  EXPECT_NE(RunPlaceJob(ground, {.evaluations = 40, .seed = 8}, 4)->start, jobs[4].start);
  const PlaceResult whole = PlaceWinches(ground, {.job = options, .jobs = 5});
  std::reverse(jobs.begin(), jobs.end());
  const auto joined = JoinPlaceJobs(ground, jobs);
  ASSERT_TRUE(joined);
  EXPECT_EQ(joined->placement->positions, whole.placement->positions);
  EXPECT_EQ(joined->evaluations, whole.evaluations);
  ASSERT_EQ(joined->history.size(), whole.history.size());
  EXPECT_EQ(joined->history.back().evaluations, whole.history.back().evaluations);
}

TEST(PlaceWinches, StartsAreSpreadThenOnCornersThenAnywhere) {
  const PlacementGround ground = Prepared(Room(12, 8), {.anchors = 5});
  EXPECT_EQ(PlaceStart(ground, 1, 0), (std::vector<double>{0, 8, 16, 24, 32}));
  const auto on_corner = [&](double position) {
    const auto corners = ground.outline().corners();
    return std::find(corners.begin(), corners.end(), position) != corners.end();
  };
  for (std::size_t job = 1; job < 30; ++job) {
    const std::vector<double> start = PlaceStart(ground, 1, job);
    ASSERT_EQ(start.size(), 5u);
    EXPECT_TRUE(std::is_sorted(start.begin(), start.end()));
    const auto cornered = std::count_if(start.begin(), start.end(), on_corner);
    EXPECT_GE(cornered, job == 1 ? 4 : job % 2) << job;
    EXPECT_LE(cornered, job % 2 == 1 ? 4 : 0) << job;
    EXPECT_NE(start, PlaceStart(ground, 1, job + 2));
    EXPECT_NE(start, PlaceStart(ground, 2, job));
  }
}

TEST(PlaceWinches, StopsAtItsEvaluationsAndWhenAsked) {
  const PlacementGround ground = Prepared(Hall(), {.anchors = 4});
  const auto one = RunPlaceJob(ground, {.evaluations = 1}, 0);
  ASSERT_TRUE(one);
  EXPECT_EQ(one->evaluations, 1);
  EXPECT_EQ(one->positions, one->start);
  int asked = 0;
  EXPECT_FALSE(RunPlaceJob(ground, {.keep_going = [&asked] { return ++asked < 10; }}, 0));
  EXPECT_EQ(asked, 10);
  int told = 0;
  const PlaceResult result = PlaceWinches(
      ground,
      {.job = {.evaluations = 5}, .jobs = 9, .watch = [&told](std::string_view, double) { return ++told < 4; }});
  EXPECT_EQ(result.jobs, 3u) << "the jobs so far are joined";
}

TEST(PlaceWinches, TellsOfTasksThatCannotBeHeld) {
  World world = Hall();
  const PlacementGround blocked = Prepared(world, {.tasks = {{1, 1}, {5, 5}}});
  PlaceResult result = PlaceWinches(blocked, {});
  EXPECT_EQ(result.status, PlaceStatus::kInfeasible);
  EXPECT_EQ(result.obstruction, WorkspaceObstruction::kTaskOutside);
  EXPECT_EQ(result.explanation,
            "task 2 (5, 5) lies inside an obstacle or a wall, or within its clearance: no workspace can hold it");
  EXPECT_EQ(result.evaluations, 0);
  world.obstacles.push_back(random_scene::PolygonObstacle(world, Rectangle({17, -1}, {18, 13})));
  result = PlaceWinches(Prepared(world, {.tasks = {{1, 1}, {19, 5}}}), {});
  EXPECT_EQ(result.explanation, "task 2 (19, 5) is cut off from task 1 (1, 1): no workspace can hold it");
}

TEST(PlaceWinches, TellsWhenNothingHoldsAllTasks) {
  const PlacementGround ground = Prepared(Room(4, 3), {.anchors = 3, .tasks = {{0, 0}, {4, 0}, {4, 3}, {0, 3}}});
  const PlaceResult result = PlaceWinches(ground, {.job = {.evaluations = 50}, .jobs = 2});
  EXPECT_EQ(result.status, PlaceStatus::kBudgetExceeded) << "that no triangle holds four corners is not proved";
  EXPECT_EQ(result.obstruction, WorkspaceObstruction::kNoBoundary);
  EXPECT_TRUE(result.history.empty());
  ASSERT_TRUE(result.placement);
  EXPECT_NEAR(result.placement->worth.outside, 2.4, 1e-9);
  EXPECT_EQ(result.details.tasks_held, 3u);
  EXPECT_NE(result.explanation.find("the best one holds 3"), std::string::npos) << result.explanation;
}

TEST(PlaceWinches, JobsOfAnotherGroundAreRefused) {
  const std::vector<PlaceJob> jobs = RunJobs(Prepared(Hall(), {.anchors = 4}), {.evaluations = 20}, 2);
  World changed = Hall();
  changed.obstacles.pop_back();
  const auto joined = JoinPlaceJobs(Prepared(changed, {.anchors = 4}), jobs);
  ASSERT_FALSE(joined);
  EXPECT_NE(joined.error().message.find("run it again"), std::string::npos) << joined.error().message;
}

TEST(PlaceWinches, DoublingAllCoordinatesQuadruplesTheArea) {
  const PlaceOptions options{.job = {.evaluations = 80}, .jobs = 3};
  const PlaceResult one = PlaceWinches(Prepared(Hall(), {.anchors = 4}), options);
  const PlaceResult two = PlaceWinches(Prepared(Doubled(Hall()), {.anchors = 4}), options);
  EXPECT_NEAR(two.placement->worth.value, 4 * one.placement->worth.value, 1e-6 * two.placement->worth.value);
}

/// The best value of all placements whose positions are multiples of a step.
double BestOnGrid(const PlacementGround& ground, double step) {
  const int count = static_cast<int>(ground.outline().length() / step + 0.5);
  std::optional<PlacementWorth> best;
  for (int i = 0; i < count; ++i) {
    for (int k = i + 1; k < count; ++k) {
      for (int m = k + 1; m < count; ++m) {
        const auto answer = ground.Evaluate({i * step, k * step, m * step});
        if (!answer.placement || (best && !ground.IsBetter(answer.placement->worth, *best))) continue;
        best = answer.placement->worth;
      }
    }
  }
  EXPECT_TRUE(best && best->holds_all());
  return best->value;
}

TEST(PlaceWinches, NoCoarseGridIsBetter) {
  constexpr double kStep = 0.5;
  World pillar = Room(4, 3);
  pillar.obstacles.push_back(random_scene::PolygonObstacle(pillar, Rectangle({1.5, 1}, {2, 2})));
  for (const World& world : {Room(4, 3), pillar}) {
    for (const PlaceObjective objective : {PlaceObjective::kArea, PlaceObjective::kCable}) {
      const PlacementGround ground =
          Prepared(world, {.anchors = 3, .objective = objective, .tasks = {{1, 1.75}, {2.5, 1.25}}});
      const PlaceResult result = PlaceWinches(ground, {.job = {.evaluations = 400}, .jobs = 40});
      ASSERT_EQ(result.status, PlaceStatus::kSolved);
      const double found = result.placement->worth.value, grid = BestOnGrid(ground, kStep);
      EXPECT_FALSE(ground.IsBetter({0, grid}, {0, found})) << found << " against " << grid;
      // Between points of the grid each cable changes by no more than its two ends move, and so does the area's width.
      EXPECT_NEAR(found, grid, objective == PlaceObjective::kCable ? 3 * 2 * kStep : 5 * kStep);
    }
  }
}

}  // namespace
}  // namespace tautline
