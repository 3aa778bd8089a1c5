#include "tautline/planners/grid_manifold/best_base.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tautline/base/test_scale.h"
#include "tautline/planners/grid_manifold/deadlocks.h"
#include "tautline/planners/grid_manifold/manifold_oracle.h"

namespace tautline {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

CellGround Ground(const std::vector<std::string_view>& rows) { return CellGround(GridFromSketch(rows), {}); }

TEST(CandidateBases, AreTheCellsNearestToTheMiddleOfEachSquare) {
  const CellGround ground = Ground({"......", "......", "......", "...###", "...###", "...###"});
  EXPECT_THAT(CandidateBases(ground, BaseCandidates::kLattice, 3),
              ElementsAre(GridCell{1, 1}, GridCell{1, 4}, GridCell{4, 4}));
  EXPECT_THAT(CandidateBases(ground, BaseCandidates::kWalls, 3),
              ElementsAre(GridCell{1, 0}, GridCell{0, 4}, GridCell{4, 3}));
  EXPECT_EQ(CandidateBases(ground, BaseCandidates::kLattice, 1).size(), 27U);
  EXPECT_THAT(CandidateBases(Ground({"##"}), BaseCandidates::kLattice, 1), IsEmpty());
}

TEST(RankBases, PutsTheMiddleOfACorridorFirst) {
  const CellGround corridor = Ground({"..........."});
  std::vector<BaseTrial> trials;
  const auto candidates = CandidateBases(corridor, BaseCandidates::kLattice, 1);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    trials.push_back(TryBase(corridor, candidates[i], {.length_m = 5}));
    trials.back().job = i;
  }
  const auto ranked = RankBases(trials, BaseObjective::kArea);
  EXPECT_EQ(ranked[0].base, (GridCell{5, 0}));
  EXPECT_EQ(ranked[0].cells, 11);
  EXPECT_EQ(ranked[1].base, (GridCell{4, 0}));
  EXPECT_EQ(ranked.back().base, (GridCell{10, 0}));
}

TEST(RankBases, CountsNoCornerThatTheRobotCanHardlyLeave) {
  const std::vector<BaseTrial> trials{{.job = 0, .cells = 3, .closed = 0},
                                      {.job = 1, .cells = 100, .closed = 7},
                                      {.job = 2, .cells = 92, .closed = 5},
                                      {.job = 3, .cells = 200, .complete = false}};
  const auto ranked = RankBases(trials, BaseObjective::kDeadlock);
  ASSERT_EQ(ranked.size(), 3U);
  EXPECT_EQ(ranked[0].job, 2U);
  EXPECT_EQ(ranked[1].job, 1U);
  EXPECT_EQ(ranked[2].job, 0U);
}

TEST(TryBase, CountsWhatTheSlowWayFinds) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(100); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    ManifoldOptions options;
    const CellGround ground = RandomGround(rng, options.base);
    options.length_m = ground.cell_m() * rng.Uniform(0, 9);
    const ManifoldOracle oracle(ground, options);
    std::set<std::pair<int, int>> cells;
    for (const auto& [state, distance] : oracle.distances()) cells.emplace(std::get<0>(state), std::get<1>(state));
    const BaseTrial trial = TryBase(ground, options.base, {.length_m = options.length_m, .deadlocks = true});
    ASSERT_EQ(trial.vertices, static_cast<std::int64_t>(oracle.distances().size()));
    ASSERT_EQ(trial.cells, static_cast<std::int64_t>(cells.size()));
    const GridManifold manifold = GridManifold::Build(ground, options);
    const DeadlockAreas areas(manifold);
    ASSERT_EQ(trial.closed, areas.closed_vertices());
    ASSERT_EQ(trial.deadlocks, static_cast<std::int64_t>(areas.deadlocks().size()));
  }
}

TEST(TryBase, TellsThatABudgetRanOut) {
  const CellGround ground(MakeGrid(150, 150, CellState::kFree), {});
  EXPECT_TRUE(TryBase(ground, {0, 0}, {.length_m = 300}).complete);
  EXPECT_FALSE(TryBase(ground, {0, 0}, {.length_m = 300, .max_vertices = 3000}).complete);
}

}  // namespace
}  // namespace tautline
