#include "bench/peers/word_string_manifold.h"

#include <gtest/gtest.h>

#include "tautline/base/test_scale.h"
#include "tautline/planners/grid_manifold/manifold_oracle.h"

namespace tautline {
namespace {

/// The sum of all distances, in cells.
double SumOf(const GridManifold& manifold) {
  double sum = 0;
  for (std::uint32_t page = 0; page < manifold.pages(); ++page) {
    for (int cell = 0; cell < 64; ++cell) {
      if (manifold.Has({page, cell})) sum += CellsOf(manifold.distance({page, cell}));
    }
  }
  return sum;
}

TEST(WordStringManifold, FindsWhatTheManifoldHas) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(60); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    ManifoldOptions options;
    const CellGround ground = RandomGround(rng, options.base);
    if (ground.names().size() >= 100) continue;
    options.connectivity = seed % 2 == 0 ? Connectivity::kFour : Connectivity::kEight;
    options.length_m = ground.cell_m() * rng.UniformInt(0, 9);
    const GridManifold manifold = GridManifold::Build(ground, options);
    const SearchedStates states = SearchWordStrings(ground, options), cells = SearchCells(ground, options);
    EXPECT_EQ(static_cast<std::int64_t>(states.states), manifold.Count().vertices);
    EXPECT_NEAR(states.distances, SumOf(manifold), 1e-6);
    std::size_t carrying = 0;
    for (const std::uint32_t count : manifold.Multiplicity()) carrying += count > 0 ? 1 : 0;
    EXPECT_EQ(cells.states, carrying);
  }
}

}  // namespace
}  // namespace tautline
