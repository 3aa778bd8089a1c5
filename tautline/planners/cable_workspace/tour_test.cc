#include "tautline/planners/cable_workspace/tour.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tautline/base/test_scale.h"
#include "tautline/planners/cable_workspace/exact_tour.h"
#include "tautline/planners/cable_workspace/random_workspace.h"
#include "tautline/planners/cable_workspace/tour_bound.h"
#include "tautline/planners/cable_workspace/tour_search.h"

namespace tautline {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Distances in the plane; now and then on a coarse lattice, where many tie and places repeat.
TourDistances RandomDistances(Rng& rng, std::size_t tasks) {
  std::vector<Point> places;
  const bool lattice = rng.UniformInt(0, 2) == 0, round = rng.UniformInt(0, 1) == 0;
  for (std::size_t i = 0; i < tasks + 2; ++i) {
    const Point p{rng.Uniform(0, 10), rng.Uniform(0, 10)};
    places.push_back(lattice ? Point{std::floor(p.x / 2), std::floor(p.y / 2)} : p);
  }
  if (round) places[tasks + 1] = places[tasks];
  TourDistances distances(tasks);
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) distances.Set(i, k, Distance(places[i], places[k]));
  }
  return distances;
}

/// The first of the shortest orders, by looking at all.
std::vector<std::size_t> TryAllOrders(const TourDistances& distances) {
  std::vector<std::size_t> order(distances.tasks());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<std::size_t> best = order;
  do {
    if (TourLength(distances, order) < TourLength(distances, best) - 1e-9) best = order;
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

bool IsPermutation(std::vector<std::size_t> order, std::size_t tasks) {
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (order[i] != i) return false;
  }
  return order.size() == tasks;
}

TEST(FindExactTour, IsTheFirstOfTheShortestOfAllOrders) {
  Rng rng(21);
  for (std::int64_t i = ScaledTestCount(300); i > 0; --i) {
    const auto tasks = static_cast<std::size_t>(rng.UniformInt(0, 7));
    const TourDistances distances = RandomDistances(rng, tasks);
    EXPECT_EQ(FindExactTour(distances), TryAllOrders(distances)) << "seed 21, left " << i;
  }
}

TEST(BoundTour, IsNeverAboveTheShortestTourAndSeldomFarBelow) {
  Rng rng(22);
  double gaps = 0;
  std::int64_t met = 0;
  const std::int64_t count = ScaledTestCount(200);
  for (std::int64_t i = count; i > 0; --i) {
    const TourDistances distances = RandomDistances(rng, static_cast<std::size_t>(rng.UniformInt(0, 10)));
    const double length = TourLength(distances, FindExactTour(distances));
    const double bound = BoundTour(distances, {.known_length = 1.1 * length});
    EXPECT_LE(bound, length * (1 + 1e-9)) << "seed 22, left " << i;
    gaps += length > 0 ? 1 - bound / length : 0;
    met += bound >= length * (1 - 1e-3) ? 1 : 0;
  }
  EXPECT_LT(gaps / static_cast<double>(count), 0.02);
  EXPECT_GT(met, count / 4);
}

TEST(ImproveTour, ComesNearTheShortestTourAndNeverBelow) {
  Rng rng(23);
  for (std::int64_t i = ScaledTestCount(60); i > 0; --i) {
    const auto tasks = static_cast<std::size_t>(rng.UniformInt(1, 12));
    const TourDistances distances = RandomDistances(rng, tasks);
    const double least = TourLength(distances, FindExactTour(distances));
    const auto first = NearestNeighbourTour(distances);
    const auto settled = ImproveTour(distances, first, {}, rng);
    const auto searched = ImproveTour(distances, settled, {.rounds = 300}, rng);
    for (const auto& order : {first, settled, searched}) {
      ASSERT_TRUE(IsPermutation(order, tasks));
      EXPECT_GE(TourLength(distances, order), least * (1 - 1e-9));
    }
    EXPECT_LE(TourLength(distances, settled), TourLength(distances, first) * (1 + 1e-9));
    EXPECT_LE(TourLength(distances, searched), least * 1.02) << "seed 23, left " << i;
  }
}

TEST(ImproveTour, OfManyTasksIsWithinAFewPercentOfTheBoundAndRepeatable) {
  Rng scenes(24);
  for (const std::size_t tasks : {std::size_t{16}, std::size_t{60}, std::size_t{200}}) {
    const TourDistances distances = RandomDistances(scenes, tasks);
    Rng one(1), two(1);
    const auto order = ImproveTour(distances, NearestNeighbourTour(distances), {.rounds = 4000}, one);
    EXPECT_EQ(order, ImproveTour(distances, NearestNeighbourTour(distances), {.rounds = 4000}, two));
    ASSERT_TRUE(IsPermutation(order, tasks));
    const double length = TourLength(distances, order), bound = BoundTour(distances, {.known_length = length});
    EXPECT_LE(bound, length * (1 + 1e-9));
    EXPECT_LE(length, 1.06 * bound) << tasks << " tasks";
  }
}

/// The case of five tasks among three obstacles.
struct Hall {
  CableGround ground;
  Anchors anchors;
  WorkspaceBoundary boundary;
};

Hall FiveTaskHall() {
  World world{.outline = {{0, 0}, {200, 0}, {200, 200}, {0, 200}}};
  const auto add = [&world](Ring ring) {
    world.obstacles.push_back(
        {.name = "o" + std::to_string(world.obstacles.size() + 1), .polygon = PolygonWithHoles{std::move(ring), {}}});
  };
  add({{60, 90}, {90, 90}, {75, 120}});
  add({{120, 60}, {160, 60}, {160, 70}, {130, 70}, {130, 110}, {120, 110}});
  add({{40, 40}, {60, 35}, {70, 50}, {55, 65}, {38, 58}});
  const std::vector<Point> points{{0, 0}, {0, 200}, {200, 200}, {200, 0}};
  const std::vector<Polyline> laid{{{100, 30}, {0, 0}},
                                   {{100, 30}, {100, 80}, {50, 80}, {0, 200}},
                                   {{100, 30}, {105, 150}, {200, 200}},
                                   {{100, 30}, {200, 0}}};
  auto ground = CableGround::Prepare(world).value();
  auto anchors = PlaceAnchors(ground, points).value();
  auto boundary = BoundaryOfCables(ground, anchors, laid).value();
  return {std::move(ground), std::move(anchors), std::move(boundary)};
}

const std::vector<Point> kFiveTasks{{110, 100}, {150, 30}, {100, 60}, {60, 20}, {60, 80}};

TEST(PlanTour, OverFiveTasksAndBack) {
  const Hall hall = FiveTaskHall();
  const WorkspaceRegion region(hall.ground, hall.anchors, hall.boundary);
  Rng rng(1);
  for (const std::optional<Point>& goal : {std::optional<Point>(), std::optional<Point>({80, 20})}) {
    const auto tour = PlanTour(region, {{80, 20}, kFiveTasks, goal}, {}, rng);
    ASSERT_TRUE(tour);
    EXPECT_THAT(tour->order, ElementsAre(1, 2, 0, 4, 3));
    EXPECT_NEAR(tour->path.length, 307.48026290333365, 1e-9);
    EXPECT_TRUE(tour->optimal);
    EXPECT_EQ(tour->bound, tour->path.length);
    EXPECT_EQ(tour->legs.size(), 6u);
    EXPECT_FALSE(tour->stopped);
    EXPECT_FALSE(tour->outside);
  }
}

TEST(PlanTour, OverFewTasks) {
  const Hall hall = FiveTaskHall();
  const WorkspaceRegion region(hall.ground, hall.anchors, hall.boundary);
  Rng rng(1);
  const Point start{80, 20}, goal{100, 60};
  const auto none = PlanTour(region, {start, {}, {}}, {}, rng), to_goal = PlanTour(region, {start, {}, goal}, {}, rng);
  EXPECT_EQ(none->path.length, 0);
  EXPECT_EQ(none->path.points, (Polyline{start}));
  EXPECT_TRUE(none->optimal);
  EXPECT_NEAR(to_goal->path.length, Distance(start, goal), 1e-12);
  // Tasks that repeat, and one at the start.
  const auto same = PlanTour(region, {start, {goal, start, goal}, {}}, {}, rng);
  EXPECT_THAT(same->order, ElementsAre(0, 2, 1));
  EXPECT_NEAR(same->path.length, 2 * Distance(start, goal), 1e-12);
  const auto one = PlanTour(region, {start, {goal}, {}}, {}, rng);
  EXPECT_THAT(one->order, ElementsAre(0));
  const auto searched = PlanTour(region, {start, {goal, start, goal}, {}}, {.most_exact = 0}, rng);
  EXPECT_NEAR(searched->path.length, 2 * Distance(start, goal), 1e-12);
  EXPECT_TRUE(searched->optimal);
}

TEST(PlanTour, NamesAllThatIsOutside) {
  const Hall hall = FiveTaskHall();
  const WorkspaceRegion region(hall.ground, hall.anchors, hall.boundary);
  Rng rng(1);
  const auto tour = PlanTour(region, {{80, 20}, {{75, 100}, {80, 30}, {10, 100}}, {}}, {}, rng);
  ASSERT_FALSE(tour);
  EXPECT_EQ(tour.error().obstruction, WorkspaceObstruction::kTaskOutside);
  EXPECT_THAT(tour.error().tasks, ElementsAre(0, 2));
  EXPECT_THAT(tour.error().explanation, HasSubstr("task 1 (75, 100) is outside"));
  EXPECT_THAT(tour.error().explanation, HasSubstr("task 3 (10, 100) is outside"));
  EXPECT_EQ(PlanTour(region, {{75, 100}, {}, {}}, {}, rng).error().obstruction, WorkspaceObstruction::kStartOutside);
  EXPECT_EQ(PlanTour(region, {{80, 20}, {}, Point{75, 100}}, {}, rng).error().obstruction,
            WorkspaceObstruction::kGoalOutside);
}

TEST(PlanTour, ThatIsStoppedVisitsAllTasksStill) {
  const Hall hall = FiveTaskHall();
  const WorkspaceRegion region(hall.ground, hall.anchors, hall.boundary);
  Rng places(5);
  std::vector<Point> tasks;
  for (int i = 0; i < 40; ++i) tasks.push_back(RandomPlaceInside(places, region));
  std::optional<double> last;
  for (const int calls : {0, 10, 60, 1000, 1'000'000}) {
    Rng rng(1);
    int left = calls;
    const auto tour = PlanTour(region, {{80, 20}, tasks, {}}, {.watch = [&](auto, double) { return left-- > 0; }}, rng);
    ASSERT_TRUE(tour);
    EXPECT_EQ(tour->stopped, calls < 1'000'000);
    EXPECT_TRUE(IsPermutation(tour->order, tasks.size()));
    EXPECT_LE(tour->bound, tour->path.length);
    last = tour->path.length;
  }
  Rng rng(1);
  EXPECT_EQ(PlanTour(region, {{80, 20}, tasks, {}}, {}, rng)->path.length, *last);
}

class RandomTours : public ::testing::TestWithParam<bool> {};

TEST_P(RandomTours, AreTheShortestOverAllOrders) {
  Rng rng(25);
  for (std::int64_t i = ScaledTestCount(60); i > 0; --i) {
    RandomWorkspace workspace = MakeRandomWorkspace(rng, GetParam());
    const WorkspaceRegion& region = RegionOf(workspace);
    TourStops stops{RandomPlaceInside(rng, region), {}, {}};
    for (int k = rng.UniformInt(0, 5); k > 0; --k) stops.tasks.push_back(RandomPlaceInside(rng, region));
    if (rng.UniformInt(0, 1) == 0) stops.goal = RandomPlaceInside(rng, region);
    const auto tour = PlanTour(region, stops, {}, rng);
    ASSERT_TRUE(tour) << "seed 25, left " << i;
    ASSERT_TRUE(IsPermutation(tour->order, stops.tasks.size()));
    double legs = 0;
    for (const TautPath& leg : tour->legs) legs += leg.length;
    EXPECT_NEAR(legs, tour->path.length, 1e-9);
    // By paths that choose their ways leg by leg: no shorter tour is left out.
    const auto length = [&](Point a, Point b) {
      return ShortestPath(region, region.WaysTo(a), region.WaysTo(b)).path.length;
    };
    std::vector<std::size_t> order(stops.tasks.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    double least = std::numeric_limits<double>::infinity();
    do {
      double sum = 0;
      Point at = stops.start;
      for (const std::size_t task : order) {
        sum += length(at, stops.tasks[task]);
        at = stops.tasks[task];
      }
      least = std::min(least, sum + length(at, stops.goal.value_or(stops.start)));
    } while (std::next_permutation(order.begin(), order.end()));
    EXPECT_NEAR(tour->bound, tour->optimal ? tour->path.length : least, 1e-9);
    EXPECT_GE(tour->path.length, least - 1e-9);
    EXPECT_EQ(tour->optimal, tour->path.length < least + 1e-9);
  }
}

TEST_P(RandomTours, DistancesAreAMetric) {
  Rng rng(26);
  for (std::int64_t i = ScaledTestCount(60); i > 0; --i) {
    RandomWorkspace workspace = MakeRandomWorkspace(rng, GetParam());
    const WorkspaceRegion& region = RegionOf(workspace);
    std::vector<Walk> ways;
    for (int k = 0; k < 4; ++k) ways.push_back(region.WaysTo(RandomPlaceInside(rng, region))[0]);
    const auto length = [&](std::size_t a, std::size_t b) {
      return region.ground().space().Pull(region.Between(ways[a], ways[b])).length;
    };
    for (std::size_t a = 0; a < ways.size(); ++a) {
      EXPECT_EQ(length(a, a), 0);
      for (std::size_t b = 0; b < ways.size(); ++b) {
        EXPECT_NEAR(length(a, b), length(b, a), 1e-9);
        for (std::size_t c = 0; c < ways.size(); ++c) EXPECT_LE(length(a, c), length(a, b) + length(b, c) + 1e-9);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, RandomTours, ::testing::Bool());

}  // namespace
}  // namespace tautline
