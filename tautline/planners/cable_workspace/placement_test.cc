#include "tautline/planners/cable_workspace/placement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/homotopy/random_scene.h"
#include "tautline/planners/cable_workspace/best.h"

namespace tautline {
namespace {

World Room(double width, double height) {
  World world;
  world.outline = Rectangle({0, 0}, {width, height});
  return world;
}

PlacementGround Prepared(const World& world, const PlacementOptions& options) {
  return PlacementGround::Prepare(world, options).value();
}

std::string FaultOf(const World& world, const PlacementOptions& options) {
  const auto ground = PlacementGround::Prepare(world, options);
  return ground ? "" : ToString(ground.error());
}

TEST(PlacementGround, RefusesWhatCannotBeMeant) {
  const World room = Room(4, 3);
  EXPECT_EQ(FaultOf(room, {.anchors = 2}), "anchors: 2 anchors hold no area between their cables: give 3 or more");
  EXPECT_EQ(FaultOf(room, {.objective = PlaceObjective::kCable}),
            "tasks: without tasks the least cable is none at all: give the scene `tasks`, or maximise the area");
  EXPECT_EQ(FaultOf(room, {.max_boundary = 0.0}),
            "max_boundary: the longest boundary must be a positive number of metres");
  const Future unknown{1, {{"nobody", {{1, 1}, {2, 2}}}}};
  EXPECT_NE(FaultOf(room, {.futures = {unknown}}), "");
}

TEST(PlacementGround, WinchesInTheCornersOfARectangleHoldAllOfIt) {
  const PlacementGround ground = Prepared(Room(4, 3), {.anchors = 4});
  const auto answer = ground.Evaluate({0, 4, 7, 11});
  ASSERT_TRUE(answer.placement);
  EXPECT_TRUE(answer.complete);
  EXPECT_EQ(answer.placement->worth, (PlacementWorth{0, 12}));
  EXPECT_NEAR(answer.placement->boundary.length, 14, 1e-12);
  for (const double cable : ground.DetailsOf(*answer.placement).longest_cables) EXPECT_NEAR(cable, 5, 1e-12);
}

TEST(PlacementGround, SortsAndWrapsPositions) {
  const PlacementGround ground = Prepared(Room(4, 3), {.anchors = 4});
  const auto answer = ground.Evaluate({11, -7, 14 + 4, -14});
  ASSERT_TRUE(answer.placement);
  EXPECT_EQ(answer.placement->positions, (std::vector<double>{0, 4, 7, 11}));
}

TEST(PlacementGround, TwoWinchesInOnePlaceAreNoPlacement) {
  const PlacementGround ground = Prepared(Room(4, 3), {.anchors = 4});
  EXPECT_FALSE(ground.Evaluate({0, 4, 4, 11}).placement);
  EXPECT_FALSE(ground.Evaluate({0, 1, 2, 3}).placement) << "all on one wall: no area";
}

TEST(PlacementGround, TheDefaultLimitAdmitsTheWholeOutlineWithClearance) {
  World room = Room(4, 3);
  room.clearance = 0.25;
  const auto answer = Prepared(room, {.anchors = 4}).Evaluate({0, 4, 7, 11});
  ASSERT_TRUE(answer.placement);
  EXPECT_NEAR(answer.placement->worth.value, 3.5 * 2.5, 0.01) << "but for what the arcs are too large";
}

TEST(PlacementGround, TasksThatNoWorkspaceHoldsAreKnownAtOnce) {
  World world = Room(9, 3);
  EXPECT_FALSE(Prepared(world, {.tasks = {{1, 1}, {8, 1}}}).lost_task());
  Obstacle wall;
  wall.name = "wall";
  wall.polygon = PolygonWithHoles{Rectangle({4, -1}, {5, 4}), {}};
  world.obstacles.push_back(wall);
  EXPECT_EQ(Prepared(world, {.tasks = {{1, 1}, {8, 1}}}).lost_task(), 1u) << "cut off";
  EXPECT_EQ(Prepared(world, {.tasks = {{1, 1}, {2, 1}, {4.5, 1}}}).lost_task(), 2u) << "blocked";
  EXPECT_EQ(Prepared(world, {.tasks = {{8, 1}, {7, 1}}}).lost_task(), std::nullopt) << "the outline is that of theirs";
}

TEST(PlacementGround, WithoutAllTasksItCountsHowFarTheyAreOutside) {
  const PlacementGround ground =
      Prepared(Room(4, 3), {.anchors = 3, .tasks = {{0, 0}, {4, 0}, {4, 3}, {0, 3}, {1, 2}}});
  const auto answer = ground.Evaluate({0, 4, 7});
  ASSERT_TRUE(answer.placement);
  EXPECT_NEAR(answer.placement->worth.outside, 2.4 + 1, 1e-12) << "of a corner and of (1, 2), from the diagonal";
  EXPECT_EQ(answer.placement->worth.value, 6);
  EXPECT_EQ(ground.DetailsOf(*answer.placement).tasks_held, 3u);
  EXPECT_FALSE(answer.placement->worth.holds_all());
  EXPECT_TRUE(ground.IsBetter({3, 1}, {4, 6}));
  EXPECT_TRUE(ground.IsBetter({3, 6}, {3, 5}));
}

TEST(PlacementGround, LessCableIsBetterOnceAllTasksAreHeld) {
  const PlacementGround ground =
      Prepared(Room(4, 3), {.anchors = 3, .objective = PlaceObjective::kCable, .tasks = {{1, 1}, {2, 2}}});
  EXPECT_TRUE(ground.IsBetter({0, 10}, {0, 11}));
  EXPECT_TRUE(ground.IsBetter({0, 11}, {0.5, 1}));
  EXPECT_TRUE(ground.IsBetter({0.5, 5}, {0.5, 4})) << "area, until then";
}

/// By definition, with another test of what is inside: the rest of a turn.
double SlowOutside(const PlacementGround& ground, const WorkspaceBoundary& boundary) {
  double outside = 0;
  for (const Point task : ground.options().tasks) {
    double distance = 1e300;
    for (std::size_t i = 0; i < boundary.ring.size(); ++i) {
      const Point a = boundary.ring[i], b = boundary.ring[(i + 1) % boundary.ring.size()];
      for (int k = 0; k <= 1000; ++k) distance = std::min(distance, Distance(task, a + k * 1e-3 * (b - a)));
    }
    if (!ContainsPoint(boundary.ring, task)) outside += distance;
  }
  return outside;
}

/// By definition: all boundaries that hold the tasks, each looked at.
PlacementWorth SlowWorth(const PlacementGround& ground, const Anchors& anchors, const World& world) {
  const PlacementOptions& asked = ground.options();
  const BoundaryList list =
      FindBoundaries(ground.ground(), anchors, {.max_boundary = ground.max_boundary(), .budget = asked.budget});
  EXPECT_TRUE(list.complete);
  std::vector<Point> points;
  for (const Socket& anchor : anchors) points.push_back(anchor.base);
  PlacementWorth best;
  bool any = false;
  for (const WorkspaceBoundary& boundary : list.boundaries) {
    PlacementWorth worth{SlowOutside(ground, boundary), boundary.area};
    if (worth.holds_all()) {
      std::vector<double> cables;
      double lost = 0;
      if (asked.futures.empty()) {
        for (const LongestCable& cable : LongestCables(ground.ground(), anchors, boundary)) {
          cables.push_back(cable.length);
        }
      } else {
        const auto outcomes = Futures::Prepare(world, points, asked.futures)->Carry(ground.ground(), anchors, boundary);
        cables = outcomes.longest_cables;
        worth.value = outcomes.expected_area;
        lost = outcomes.lost_probability;
      }
      if (asked.objective == PlaceObjective::kCable) {
        worth.value = std::accumulate(cables.begin(), cables.end(), 0.0);
        if (lost > 0) continue;
      }
    }
    if (any && !ground.IsBetter(worth, best)) continue;
    best = worth;
    any = true;
  }
  return best;
}

/// A convex future for the first obstacle that has a name.
std::vector<Future> RandomFutures(Rng& rng, const RandomScene& scene) {
  if (scene.space.islands.empty() || rng.UniformInt(0, 1) == 0) return {};
  const Island& island = scene.space.islands[0];
  const Point from = island.representative;
  const Point to = from + Point{rng.Uniform(-0.5, 0.5), rng.Uniform(-0.5, 0.5)};
  return {{0.625, {{island.name, {from, to}}}}, {0.375, {}}};
}

TEST(PlacementGround, AnEvaluationIsTheBestBoundaryByDefinition) {
  Rng rng(20260102);
  int weighed = 0, all_held = 0, with_futures = 0;
  const std::int64_t trials = ScaledTestCount(120);
  for (std::int64_t trial = 0; trial < trials; ++trial) {
    const RandomScene scene = MakeRandomScene(rng, false);
    PlacementOptions options{.anchors = static_cast<std::size_t>(rng.UniformInt(3, 4)), .budget = 100'000};
    for (int i = rng.UniformInt(0, 2); i > 0; --i) options.tasks.push_back(RandomPoint(rng, random_scene::kBox));
    if (!options.tasks.empty() && rng.UniformInt(0, 1) == 0) options.objective = PlaceObjective::kCable;
    options.futures = RandomFutures(rng, scene);
    const double length = Length(scene.world.outline);
    options.max_boundary = rng.Uniform(0.4, 1.0) * length;
    const auto prepared = PlacementGround::Prepare(scene.world, options);
    if (!prepared) continue;
    std::vector<double> positions;
    for (std::size_t i = 0; i < options.anchors; ++i) positions.push_back(rng.Uniform(0, prepared->outline().length()));
    const PlacementAnswer answer = prepared->Evaluate(positions);
    if (!answer.placement || !answer.complete) continue;
    ++weighed;
    with_futures += options.futures.empty() ? 0 : 1;
    const PlacementWorth slow = SlowWorth(*prepared, answer.placement->anchors, scene.world);
    EXPECT_NEAR(answer.placement->worth.outside, slow.outside, 1e-3 * length) << trial;
    const PlacementWorth above{slow.outside, slow.value + (prepared->IsBetter({0, 1}, {0, 2}) ? 1e-6 : -1e-6) * length};
    const PlacementAnswer beaten = prepared->Evaluate(positions, above);
    EXPECT_TRUE(!slow.holds_all() || beaten.placement->worth == answer.placement->worth) << trial;
    const PlacementDetails details = prepared->DetailsOf(*answer.placement);
    if (!slow.holds_all()) continue;
    ++all_held;
    EXPECT_NEAR(answer.placement->worth.value, slow.value, 1e-9 * length) << trial;
    const double sum = std::accumulate(details.longest_cables.begin(), details.longest_cables.end(), 0.0);
    const double value = options.objective == PlaceObjective::kCable ? sum
                         : details.futures                           ? details.futures->expected_area
                                                                     : answer.placement->boundary.area;
    EXPECT_NEAR(value, answer.placement->worth.value, 1e-9 * length) << trial << ": the details tell the same";
  }
  EXPECT_GE(weighed, trials / 4);
  EXPECT_GE(all_held, trials / 12);
  EXPECT_GE(with_futures, trials / 12);
}

}  // namespace
}  // namespace tautline
