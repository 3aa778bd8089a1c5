#include "tautline/planners/grid_manifold/accessible_region.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/planners/grid_manifold/find_way.h"
#include "tautline/planners/grid_manifold/intermediate_targets.h"
#include "tautline/planners/grid_manifold/manifold_goal_field.h"
#include "tautline/planners/grid_manifold/sketched_hall.h"

namespace tautline {
namespace {

Hall RandomHall(Rng& rng) {
  std::vector<Box> pillars;
  for (int i = rng.UniformInt(0, 3); i > 0; --i) {
    const Point low{0.1 * rng.UniformInt(4, 12), 0.1 * rng.UniformInt(1, 9)};
    pillars.push_back({low, low + Point{0.1 * rng.UniformInt(1, 4), 0.1 * rng.UniformInt(1, 4)}});
  }
  const Connectivity connectivity = rng.UniformInt(0, 2) == 0 ? Connectivity::kFour : Connectivity::kEight;
  return Hall({1.8, 1.4}, pillars, {.base = {0.25, 0.75}, .length = rng.Uniform(1, 3)}, connectivity);
}

/// A state after a random walk, wherever the cable then lies.
DriveState RandomState(Rng& rng, const Hall& hall, RobotDriver& driver) {
  DriveState state = hall.Start();
  for (int i = rng.UniformInt(0, 60), d = 0; i > 0; --i) {
    if (rng.UniformInt(0, 3) == 0) d = rng.UniformInt(0, 7);
    const auto to = hall.manifold->Step(state.at, d);
    if (to) driver.StepTo(*to, state);
  }
  return state;
}

/// What the slow way finds: every cell's distance to each piece of the cable that is not at the robot.
double ObviousClearance(const DriveState& state, Point p, double radius) {
  const Polyline shape = state.cable.Shape();
  std::size_t end = shape.size() - 1;
  while (end > 0 && Distance(shape[end], state.cable.robot()) <= radius) --end;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < end; ++i)
    least = std::min(least, Distance(p, NearestOnSegment(p, shape[i], shape[i + 1])));
  return least;
}

TEST(CableClearance, IsTheDistanceToTheCable) {
  Rng rng(3);
  for (int trial = ScaledTestCount(40); trial > 0; --trial) {
    const Hall hall = RandomHall(rng);
    RobotDriver driver(*hall.manifold, {}, {});
    CableClearance clearance(hall.ground(), 0.25);
    for (int again = 0; again < 2; ++again) {  // The second time over the first.
      const DriveState state = RandomState(rng, hall, driver);
      clearance.Measure(state.cable);
      for (int row = 0; row < hall.ground().rows(); ++row) {
        for (int column = 0; column < hall.ground().columns(); ++column) {
          const double distance = ObviousClearance(state, hall.ground().CentreOf({column, row}), 0.25);
          if (distance < 0.25) {
            EXPECT_NEAR(clearance.at({column, row}), distance, 1e-12);
          } else {
            EXPECT_TRUE(clearance.IsClear({column, row}));
          }
        }
      }
    }
  }
}

TEST(SteppingRadius, KeepsTheDiscOffTheCableAllAlongAStep) {
  EXPECT_NEAR(SteppingRadius(0.3, 0), 0.3, 1e-15);
  Rng rng(5);
  for (int i = ScaledTestCount(2000); i > 0; --i) {
    const double radius = rng.Uniform(0, 3);
    const Point a{0, 0}, b = rng.UniformInt(0, 1) == 0 ? Point{1, 0} : Point{1, 1};
    const Point cable{rng.Uniform(-4, 4), rng.Uniform(-4, 4)};
    if (std::min(Distance(a, cable), Distance(b, cable)) < SteppingRadius(radius, 1)) continue;
    EXPECT_GE(Distance(cable, NearestOnSegment(cable, a, b)), radius - 1e-12);
  }
}

TEST(FindWay, IsAsShortAsTheRegionSays) {
  Rng rng(7);
  int found = 0, none = 0;
  for (int trial = ScaledTestCount(60); trial > 0; --trial) {
    const Hall hall = RandomHall(rng);
    RobotDriver driver(*hall.manifold, {}, {});
    const DriveState state = RandomState(rng, hall, driver);
    const GridCell goal{rng.UniformInt(0, 17), rng.UniformInt(0, 13)};
    const std::vector<ManifoldVertex> vertices = hall.manifold->VerticesAt(goal);
    if (vertices.empty()) continue;
    const ManifoldGoalField field(*hall.manifold, goal);
    const OpenGround open = driver.Look(state);
    // Dijkstra by rounds over the open steps.
    std::vector<std::pair<ManifoldVertex, LatticeDistance>> met{{state.at, 0}};
    for (std::size_t i = 0; i < met.size(); ++i) {
      for (int d = 0; d < kDirections; ++d) {
        if (hall.manifold->atlas().connectivity() == Connectivity::kFour && d % 2 == 1) continue;
        const auto to = open.Step(met[i].first, d);
        if (!to) continue;
        const LatticeDistance distance = met[i].second + StepLength(d);
        const bool worse = std::any_of(
            met.begin(), met.end(), [&](const auto& other) { return other.first == *to && other.second <= distance; });
        if (!worse) met.push_back({*to, distance});
      }
    }
    LatticeDistance best = kUnreached;
    for (const auto& [v, distance] : met) {
      if (field.distance(v) == 0) best = std::min(best, distance);
    }
    const auto way = FindWay(open, state.at,
                             {.remaining = [&](ManifoldVertex v) { return field.distance(v); },
                              .holds = [&](ManifoldVertex v) { return field.distance(v) == 0; }});
    EXPECT_EQ(way.empty(), best == kUnreached);
    if (way.empty()) {
      ++none;
      continue;
    }
    ++found;
    LatticeDistance length = 0;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
      int d = 0;
      while (open.Step(way[i], d) != std::optional(way[i + 1])) ASSERT_LT(++d, kDirections);
      length += StepLength(d);
    }
    EXPECT_EQ(length, best);
  }
  EXPECT_GE(found, 10 * ScaledTestCount(60) / 60);
  EXPECT_GE(none, ScaledTestCount(60) / 60);
}

TEST(AccessibleRegion, HasItsCentreWhereAllSearchesSay) {
  Rng rng(9);
  for (int trial = ScaledTestCount(30); trial > 0; --trial) {
    const Hall hall = RandomHall(rng);
    RobotDriver driver(*hall.manifold, {}, {});
    const DriveState state = RandomState(rng, hall, driver);
    const AccessibleRegion region(driver.Look(state), state.at);
    std::size_t best = 0;
    LatticeDistance least = kUnreached;
    for (std::size_t v = 0; v < region.size(); ++v) {
      const auto distances = region.DistancesFrom(v);
      const LatticeDistance eccentricity = *std::max_element(distances.begin(), distances.end());
      if (eccentricity >= least) continue;
      least = eccentricity;
      best = v;
    }
    EXPECT_EQ(region.Centre(), best);
  }
}

TEST(FindIntermediateTargets, AreTheCornersOfAnEmptyHall) {
  const Hall hall({2.1, 1.1}, {}, {.base = {1.05, 0.55}, .length = 4});
  RobotDriver driver(*hall.manifold, {}, {});
  const DriveState state = hall.Start();
  const AccessibleRegion region(driver.Look(state), state.at);
  EXPECT_EQ(region.size(), 21U * 11U);
  EXPECT_EQ(region.Centre(), 0U) << "the robot stands in the middle";
  const auto targets = FindIntermediateTargets(region, driver.coarse());
  std::vector<std::pair<int, int>> cells;
  for (const IntermediateTarget& target : targets) {
    const GridCell cell = hall.manifold->CellOf(target.vertex);
    cells.push_back({cell.column, cell.row});
  }
  EXPECT_THAT(cells, testing::UnorderedElementsAre(testing::Pair(0, 0), testing::Pair(20, 0), testing::Pair(0, 10),
                                                   testing::Pair(20, 10)));
}

TEST(SampleTargets, AreAllVerticesAtTheFinest) {
  const Hall hall({2.1, 1.1}, {}, {.base = {1.05, 0.55}, .length = 4});
  RobotDriver driver(*hall.manifold, {}, {});
  const DriveState state = hall.Start();
  const AccessibleRegion region(driver.Look(state), state.at);
  EXPECT_EQ(SampleTargets(*hall.manifold, region, 1).size(), region.size() - 1);
  EXPECT_EQ(SampleTargets(*hall.manifold, region, 10).size(), 6U) << "3 columns and 2 rows";
}

}  // namespace
}  // namespace tautline
