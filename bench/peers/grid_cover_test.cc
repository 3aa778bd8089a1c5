#include "bench/peers/grid_cover.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bench/tether_queries.h"
#include "tautline/base/test_scale.h"
#include "tautline/homotopy/random_scene.h"
#include "tautline/homotopy/sketched_scene.h"
#include "tautline/planners/tether/tether_planner.h"

namespace tautline {
namespace {

/// A question with its points moved to the centres of their cells; nothing where one of those is not free.
struct GridQuery {
  TetherQuery query;
  GridCover::Question question;
};
std::optional<GridQuery> OnGrid(const TetherPlanner& planner, const GridCover& grid, TetherQuery query) {
  const auto base = grid.CentreAt(query.tether.base), robot = grid.CentreAt(query.tether.laid->back()),
             goal = grid.CentreAt(query.goal);
  if (!base || !robot || !goal) return std::nullopt;
  query.tether.base = *base;
  query.tether.laid->insert(query.tether.laid->begin(), *base);
  query.tether.laid->push_back(*robot);
  query.goal = *goal;
  GridCover::Question question{*robot, planner.space().rays().WordOf(*query.tether.laid), *goal};
  return GridQuery{query, std::move(question)};
}

/// A path of the grid is a path of the plane: the exact answer is no longer, and exists where the grid's does.
void ExpectExactNoLonger(const TetherPlanner& planner, const GridQuery& asked, const GridCover::Motion& motion) {
  if (!motion.length) return;
  const PlanResult result = planner.Plan(asked.query.tether, asked.query.goal);
  ASSERT_TRUE(result.motion);
  EXPECT_LE(result.motion->path.length, *motion.length * (1 + 1e-9));
}

TEST(GridCover, IsNeverShorterThanTheLibrary) {
  const std::int64_t trials = ScaledTestCount(40);
  std::size_t answered = 0;
  for (std::int64_t seed = 0; seed < trials; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const TetherPlanner planner = TetherPlanner::Prepare(MakeRandomScene(rng, false).world).value();
    const GridCover grid(planner.space(), 0.2);
    for (TetherQuery& query : BindingTetherQueries(rng, planner.space(), {.places = 6, .count = 4})) {
      query.tether.length *= 1.08;  // What a grid needs more.
      const auto asked = OnGrid(planner, grid, query);
      if (!asked) continue;
      auto tethers =
          grid.MakeTethers(asked->query.tether.base, {.max_length = query.tether.length, .max_states = 300'000});
      if (tethers.gave_up) continue;
      const GridCover::Motion motion = grid.Plan(tethers, asked->question, {});
      if (motion.length) ++answered;
      ExpectExactNoLonger(planner, *asked, motion);
    }
  }
  EXPECT_GT(answered, static_cast<std::size_t>(trials) / 4);
}

TEST(GridCover, IsEightPercentLongerAtMostWhereThereIsRoom) {
  const auto sketch = Sketch({"...............",  //
                              "..aaa....bbb...",  //
                              "..aaa....bbb...",  //
                              "......ccc......",  //
                              "......ccc......",  //
                              "......ccc......",  //
                              "..ddd..........",  //
                              "..ddd....eee...",  //
                              "...............",  //
                              "..............."});
  const TetherPlanner planner = TetherPlanner::Prepare(sketch.world).value();
  const GridCover grid(planner.space(), 0.1);
  Rng rng(11);
  std::size_t answered = 0;
  for (const TetherQuery& query : BindingTetherQueries(rng, planner.space(), {.places = 12, .count = 60})) {
    const auto asked = OnGrid(planner, grid, query);
    if (!asked) continue;
    TetherQuery longer = asked->query;
    constexpr double kOctile = 1.0824;
    // At each bend a taut curve touches the obstacle, and the grid keeps a cell away from it.
    const double slack = 0.1 * (2 + 2 * static_cast<double>(query.tether.laid->size()) + 6);
    longer.tether.length = kOctile * query.tether.length + slack;
    const PlanResult exact = planner.Plan(asked->query.tether, asked->query.goal);
    auto tethers = grid.MakeTethers(longer.tether.base, {.max_length = longer.tether.length});
    const GridCover::Motion motion = grid.Plan(tethers, asked->question, {});
    if (!exact.motion) continue;
    ++answered;
    ASSERT_TRUE(motion.length);
    EXPECT_LE(*motion.length, kOctile * exact.motion->path.length + slack);
    ExpectExactNoLonger(planner, {longer, asked->question}, motion);
  }
  EXPECT_GT(answered, 30U);
}

}  // namespace
}  // namespace tautline
