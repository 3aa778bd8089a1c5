#include "tautline/planners/grid_manifold/manifold_goal_field.h"

#include <gtest/gtest.h>

#include "tautline/base/test_scale.h"
#include "tautline/planners/grid_manifold/manifold_oracle.h"

namespace tautline {
namespace {

/// Every distance is that of the best step, and only goals have none: together with positive steps, that makes them
/// the shortest ones.
void ExpectDescends(const GridManifold& manifold, const ManifoldGoalField& field) {
  const int step = manifold.atlas().connectivity() == Connectivity::kEight ? 1 : 2;
  std::size_t goals = 0;
  for (std::uint32_t page = 0; page < manifold.pages(); ++page) {
    for (int cell = 0; cell < 64; ++cell) {
      const ManifoldVertex v{page, cell};
      if (!manifold.Has(v)) continue;
      LatticeDistance best = kUnreached;
      for (int d = 0; d < kDirections; d += step) {
        const auto to = manifold.Step(v, d);
        if (to && field.distance(*to) != kUnreached) best = std::min(best, field.distance(*to) + StepLength(d));
      }
      if (manifold.CellOf(v) == field.goal()) {
        ASSERT_EQ(field.distance(v), 0);
        ASSERT_FALSE(field.Direction(v));
        ++goals;
        continue;
      }
      ASSERT_EQ(field.distance(v), best);
      const auto direction = field.Direction(v);
      ASSERT_EQ(direction.has_value(), best != kUnreached);
      if (!direction) continue;
      ASSERT_LT(field.distance(*manifold.Step(v, *direction)), field.distance(v));
    }
  }
  ASSERT_EQ(goals, field.goals());
}

TEST(ManifoldGoalField, DescendsToTheGoalFromEverywhere) {
  std::size_t goals = 0;
  for (std::int64_t seed = 0; seed < ScaledTestCount(300); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    ManifoldOptions options;
    const CellGround ground = RandomGround(rng, options.base);
    options.connectivity = seed % 2 == 0 ? Connectivity::kFour : Connectivity::kEight;
    options.length_m = ground.cell_m() * rng.Uniform(0, 11);
    const GridManifold manifold = GridManifold::Build(ground, options);
    const GridCell goal{rng.UniformInt(0, ground.columns() - 1), rng.UniformInt(0, ground.rows() - 1)};
    const ManifoldGoalField field(manifold, goal);
    ASSERT_NO_FATAL_FAILURE(ExpectDescends(manifold, field));
    goals = std::max(goals, field.goals());
    const auto starts = manifold.VerticesAt(options.base);
    const auto way = field.WayFrom(starts[0]);
    ASSERT_EQ(way.empty(), field.goals() == 0);
    if (way.empty()) continue;
    ASSERT_EQ(manifold.CellOf(way.back()), goal);
  }
  EXPECT_GE(goals, 2U);
}

}  // namespace
}  // namespace tautline
