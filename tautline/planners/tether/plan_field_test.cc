#include "tautline/planners/tether/plan_field.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/planners/tether/random_tether.h"

namespace tautline {
namespace {

using testing::HasSubstr;

double Extent(const TetherPlanner& planner) {
  const Point size = planner.space().free_space().box.size();
  return std::max(size.x, size.y);
}

/// The way that is left after a small step along the heading, with the cable that the robot drags along.
std::optional<double> LengthAfterStep(const TetherPlanner& planner, const Tether& tether, Point goal,
                                      const FieldSample& sample, double step) {
  const Point to = sample.at + step * Point{std::cos(*sample.heading_rad), std::sin(*sample.heading_rad)};
  Polyline laid = sample.tether.points;
  laid.push_back(to);
  const PlanResult plan = planner.Plan({tether.base, tether.length, laid}, goal);
  return plan.motion ? std::optional(plan.motion->path.length) : std::nullopt;
}

TEST(PlanField, HeadingsShortenTheWayAndLengthsAreThoseOfPlan) {
  int steps = 0;
  for (std::int64_t seed = 0; seed < ScaledTestCount(60); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    Scene scene = MakeRandomTether(rng, seed % 2 == 0).scene();
    const auto planner = TetherPlanner::Prepare(scene.world).value();
    const auto field = PlanField::Prepare(planner, *scene.tether, *scene.goal,
                                          {.resolution = Extent(planner) / 9.3, .classes = 1 + seed % 3})
                           .value();
    const double step = 1e-4 * Extent(planner);
    for (const FieldSample& sample : field.All().samples) {
      ASSERT_LE(sample.tether.length, scene.tether->length * (1 + 2 * kLengthTolerance));
      const PlanResult plan =
          planner.Plan({scene.tether->base, scene.tether->length, sample.tether.points}, *scene.goal);
      ASSERT_TRUE(plan.motion);
      ASSERT_NEAR(sample.length, plan.motion->path.length, 1e-9 * sample.length);
      ASSERT_EQ(sample.heading_rad.has_value(), sample.length > 0);
      if (sample.length < 2 * step || Distance(plan.motion->path.points[0], plan.motion->path.points[1]) < 2 * step) {
        continue;
      }
      const auto rest = LengthAfterStep(planner, *scene.tether, *scene.goal, sample, step);
      ASSERT_TRUE(rest);
      ASSERT_NEAR(*rest, sample.length - step, 1e-6 * step);
      ++steps;
    }
  }
  EXPECT_GT(steps, 5 * ScaledTestCount(60));
}

/// Every point with its classes, found one by one.
TEST(PlanField, HoldsEveryPointThatTheTetherReaches) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(40); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    Scene scene = MakeRandomTether(rng, seed % 2 == 0).scene();
    if (seed % 3 == 0) scene.world.clearance = 0.05;
    const auto planner = TetherPlanner::Prepare(scene.world).value();
    const std::int64_t classes = 1 + seed % 3;
    const auto field = PlanField::Prepare(planner, *scene.tether, *scene.goal,
                                          {.resolution = Extent(planner) / 8.7, .classes = classes})
                           .value();
    const FieldRow all = field.All();
    EXPECT_TRUE(all.complete);
    std::map<std::pair<int, int>, std::size_t> found;
    for (const FieldSample& sample : all.samples) ++found[{sample.row, sample.column}];
    if (field.from_base().status != PlanStatus::kSolved) {
      EXPECT_TRUE(found.empty());
      continue;
    }
    const auto socket = FindSocket(planner.space(), planner.ungrown(), scene.tether->base);
    for (int row = 0; row < field.grid().rows; ++row) {
      for (int column = 0; column < field.grid().columns; ++column) {
        const auto place = planner.space().Locate(field.grid().At(column, row));
        const std::size_t want = place ? planner
                                             .TethersTo(*socket, Walk(socket->exit), *place,
                                                        {.max_length = scene.tether->length, .max_count = classes})
                                             .classes.size()
                                       : 0;
        const std::size_t got = found[{row, column}];
        ASSERT_EQ(got, want) << column << ' ' << row;
      }
    }
  }
}

Scene Room() {
  Scene scene;
  scene.world.outline = {{0, 0}, {10, 0}, {10, 4}, {0, 4}};
  scene.tether = Tether{{1, 1}, 5, {}};
  scene.goal = {2.5, 1.5};
  return scene;
}

TEST(PlanField, StandsStillAtTheGoalAndPointsToItElsewhere) {
  const Scene scene = Room();
  const auto planner = TetherPlanner::Prepare(scene.world).value();
  const auto field = PlanField::Prepare(planner, *scene.tether, *scene.goal, {.resolution = 1}).value();
  EXPECT_EQ(field.grid().columns, 10);
  EXPECT_EQ(field.grid().rows, 4);
  int at_goal = 0;
  for (const FieldSample& sample : field.All().samples) {
    const Point way = *scene.goal - sample.at;
    EXPECT_NEAR(sample.length, Norm(way), 1e-12);
    EXPECT_LE(Distance(sample.at, {1, 1}), 5);
    if (sample.heading_rad) {
      EXPECT_NEAR(*sample.heading_rad, std::atan2(way.y, way.x), 1e-12);
    } else {
      ++at_goal;
      EXPECT_EQ(sample.at, (Point{2.5, 1.5}));
    }
  }
  EXPECT_EQ(at_goal, 1);
}

TEST(PlanField, IsEmptyWhereThereIsNoPlan) {
  const Scene scene = Room();
  const auto planner = TetherPlanner::Prepare(scene.world).value();
  const auto far = PlanField::Prepare(planner, *scene.tether, {9, 1}, {.resolution = 1}).value();
  EXPECT_EQ(far.from_base().obstruction, PlanObstruction::kTetherTooShort);
  EXPECT_TRUE(far.All().samples.empty());
  const auto blocked = PlanField::Prepare(planner, *scene.tether, {11, 1}, {.resolution = 1}).value();
  EXPECT_EQ(blocked.from_base().obstruction, PlanObstruction::kGoalBlocked);
  const auto outside = PlanField::Prepare(planner, {{-1, 1}, 5, {}}, {2, 1}, {.resolution = 1}).value();
  EXPECT_EQ(outside.from_base().obstruction, PlanObstruction::kStartBlocked);
  EXPECT_TRUE(outside.All().samples.empty());
}

TEST(PlanField, StopsWhenItIsTold) {
  const Scene scene = Room();
  const auto planner = TetherPlanner::Prepare(scene.world).value();
  int told = 0;
  const Watcher watch = [&told](std::string_view, double) { return ++told < 3; };
  const auto watched =
      PlanField::Prepare(planner, *scene.tether, *scene.goal, {.resolution = 1, .watch = watch}).value().All();
  EXPECT_FALSE(watched.complete);
  for (const FieldSample& sample : watched.samples) EXPECT_LT(sample.row, 2);
  int asked = 0;
  const KeepGoing keep_going = [&asked] { return ++asked < 20; };
  const auto stopped =
      PlanField::Prepare(planner, *scene.tether, *scene.goal, {.resolution = 1, .keep_going = keep_going});
  EXPECT_FALSE(stopped.value().All().complete);
}

TEST(PlanField, RefusesAbsurdResolutions) {
  const Scene scene = Room();
  const auto planner = TetherPlanner::Prepare(scene.world).value();
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    const auto field = PlanField::Prepare(planner, *scene.tether, *scene.goal, {.resolution = bad});
    ASSERT_FALSE(field);
    EXPECT_THAT(field.error().message, HasSubstr("larger than 0"));
  }
  const auto fine = PlanField::Prepare(planner, *scene.tether, *scene.goal, {.resolution = 1e-6});
  ASSERT_FALSE(fine);
  EXPECT_EQ(fine.error().code, ErrorCode::kLimitExceeded);
}

TEST(DefaultResolution, HasTwoDigitsAndAboutAHundredPoints) {
  EXPECT_DOUBLE_EQ(DefaultResolution({{0, 0}, {14, 3}}), 0.14);
  EXPECT_DOUBLE_EQ(DefaultResolution({{-5, 0}, {3, 1234}}), 13);
  EXPECT_GT(DefaultResolution({{1, 1}, {1, 1}}), 0);
}

}  // namespace
}  // namespace tautline
