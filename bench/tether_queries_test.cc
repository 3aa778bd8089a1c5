#include "bench/tether_queries.h"

#include <gtest/gtest.h>

#include "bench/bench_scene.h"
#include "bench/stopwatch.h"
#include "bench/synthetic_map.h"
#include "tautline/planners/tether/tether_planner.h"

namespace tautline {
namespace {

TEST(BindingTetherQueries, AllBindAndCanBeSolved) {
  const TetherPlanner planner = TetherPlanner::Prepare(SyntheticMap({.vertices = 400, .obstacles = 25})).value();
  Rng rng(1);
  const auto queries = BindingTetherQueries(rng, planner.space(), {.places = 10, .count = 50});
  ASSERT_EQ(queries.size(), 50U);
  for (const TetherQuery& query : queries) {
    const PlanResult result = planner.Plan(query.tether, query.goal);
    ASSERT_EQ(result.status, PlanStatus::kSolved);
    ASSERT_TRUE(result.rejected);
    EXPECT_GT(result.rejected->tether.length, query.tether.length);
    EXPECT_LE(result.motion->tether.length, query.tether.length * (1 + kLengthTolerance));
    EXPECT_GT(query.tether.laid->size(), 1U);
  }
}

TEST(RandomTetherQueries, LieInMoreThanTheShortestClassAndCanBeSolved) {
  const BenchScene scene = ReadCdt2025("maze");
  const TetherPlanner planner = TetherPlanner::Prepare(scene.world).value();
  Rng rng(1);
  const auto queries = RandomTetherQueries(
      rng, planner.space(), {.base = scene.tether.base, .length = scene.tether.length, .places = 5, .count = 50});
  ASSERT_EQ(queries.size(), 50U);
  std::size_t binding = 0;
  for (const TetherQuery& query : queries) {
    EXPECT_LE(Length(*query.tether.laid), query.tether.length * (1 + kLengthTolerance));
    const PlanResult result = planner.Plan(query.tether, query.goal);
    ASSERT_EQ(result.status, PlanStatus::kSolved);
    if (result.rejected) ++binding;
  }
  EXPECT_GT(binding, 0U);
}

TEST(Summarize, TakesTheNearestRanks) {
  std::vector<double> values;
  for (int i = 200; i >= 1; --i) values.push_back(i);
  const Summary summary = Summarize(values);
  EXPECT_EQ(summary.median, 100);
  EXPECT_EQ(summary.p99, 198);
  EXPECT_EQ(summary.worst, 200);
  EXPECT_DOUBLE_EQ(summary.mean, 100.5);
  EXPECT_EQ(Summarize({3}).median, 3);
  EXPECT_EQ(Summarize({}).worst, 0);
}

}  // namespace
}  // namespace tautline
