#include "tautline/planners/grid_manifold/grid_manifold.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string_view>
#include <thread>
#include <utility>

#include "tautline/base/test_scale.h"
#include "tautline/planners/grid_manifold/literal_manifold.h"
#include "tautline/planners/grid_manifold/manifold_file.h"
#include "tautline/planners/grid_manifold/manifold_goal_field.h"
#include "tautline/planners/grid_manifold/manifold_oracle.h"

namespace tautline {
namespace {

using testing::ElementsAre;

CellGround Ground(const std::vector<std::string_view>& rows) { return CellGround(GridFromSketch(rows), {}); }

ManifoldCounts CountsOf(const std::vector<std::string_view>& rows, const ManifoldOptions& options) {
  return GridManifold::Build(Ground(rows), options).Count();
}

ManifoldOptions Four(GridCell base, double length) {
  return {.base = base, .length_m = length, .connectivity = Connectivity::kFour};
}

TEST(GridManifold, OfOpenGroundIsTheGrid) {
  const ManifoldCounts counts = CountsOf({"...", "...", "..."}, Four({1, 1}, 2));
  EXPECT_EQ(counts.vertices, 9);
  EXPECT_EQ(counts.edges, 12);
  EXPECT_THAT(counts.multiplicity, ElementsAre(9));
  EXPECT_EQ(CellsOf(counts.farthest), 2);
}

TEST(GridManifold, WindsAroundAnIsland) {
  const std::vector<std::string_view> ring{"...", ".#.", "..."};
  EXPECT_EQ(CountsOf(ring, Four({0, 2}, 20)).vertices, 41);
  const ManifoldCounts eight = CountsOf(ring, {.base = {0, 2}, .length_m = 4});
  EXPECT_EQ(eight.vertices, 11);
  EXPECT_EQ(eight.edges, 15);
}

TEST(GridManifold, OfNoLengthIsTheBase) {
  const ManifoldCounts counts = CountsOf({"..", ".."}, {.base = {1, 0}, .length_m = 0});
  EXPECT_EQ(counts.vertices, 1);
  EXPECT_EQ(counts.edges, 0);
  EXPECT_THAT(counts.multiplicity, ElementsAre(1));
}

TEST(GridManifold, HasNoWayBetweenBlockedCellsThatTouch) {
  const ManifoldCounts counts = CountsOf({".#", "#."}, {.base = {0, 1}, .length_m = 9});
  EXPECT_EQ(counts.vertices, 1);
}

void ExpectEqualToOracle(const GridManifold& manifold, const ManifoldOptions& options) {
  const ManifoldOracle oracle(manifold.ground(), options);
  const ManifoldCounts counts = manifold.Count();
  ASSERT_EQ(counts.vertices, static_cast<std::int64_t>(oracle.distances().size()));
  ASSERT_EQ(counts.edges, oracle.Edges());
  ASSERT_EQ(counts.multiplicity, oracle.Multiplicity());
  double farthest = 0;
  for (const auto& [state, distance] : oracle.distances()) {
    farthest = std::max(farthest, distance);
    Word word;
    for (const char letter : std::get<2>(state)) word.Append({ObstacleId(std::abs(letter) - 1), letter < 0});
    const auto v = manifold.Find({std::get<1>(state), std::get<0>(state)}, word);
    ASSERT_TRUE(v);
    ASSERT_NEAR(CellsOf(manifold.distance(*v)), distance, 1e-9);
  }
  ASSERT_NEAR(CellsOf(counts.farthest), farthest, 1e-9);
}

/// Ranges in several threads, of uneven size.
ParallelRanges Threads(std::size_t count) {
  return [count](std::size_t items, const std::function<void(std::size_t, std::size_t)>& work) {
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < count; ++i) {
      threads.emplace_back([&work, i, items, count] { work(items * i / count, items * (i + 1) / count); });
    }
    for (std::thread& thread : threads) thread.join();
  };
}

TEST(GridManifold, IsWhatTheSlowWayFinds) {
  const std::int64_t trials = ScaledTestCount(400);
  std::int64_t largest = 0;
  for (std::int64_t seed = 0; seed < trials; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    ManifoldOptions options;
    const CellGround ground = RandomGround(rng, options.base);
    options.connectivity = seed % 2 == 0 ? Connectivity::kFour : Connectivity::kEight;
    const bool sparse = ground.names().size() < 4;
    options.length_m = ground.cell_m() * (seed % 3 == 0 ? rng.UniformInt(0, 9) : rng.Uniform(0, sparse ? 40 : 11));
    const GridManifold manifold = GridManifold::Build(ground, options);
    ASSERT_EQ(manifold.stop(), ManifoldStop::kNone);
    ASSERT_NO_FATAL_FAILURE(ExpectEqualToOracle(manifold, options));
    largest = std::max(largest, static_cast<std::int64_t>(manifold.value_count()));
  }
  EXPECT_GT(largest, 500);
}

TEST(GridManifold, IsWhatThePrintedConstructionFinds) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(400); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    ManifoldOptions options;
    const CellGround ground = RandomGround(rng, options.base);
    const int cells = rng.UniformInt(0, 14);
    options.length_m = ground.cell_m() * cells;
    options.connectivity = Connectivity::kFour;
    const LiteralManifold literal = BuildLiteralManifold(ground, options.base, cells, 10'000'000);
    const ManifoldCounts counts = GridManifold::Build(ground, options).Count();
    ASSERT_EQ(counts.vertices, static_cast<std::int64_t>(literal.vertices.size()));
    ASSERT_EQ(counts.edges, literal.edges);
    ASSERT_EQ(counts.multiplicity, literal.Multiplicity());
  }
}

/// Open ground with islands far enough apart that many pages wait at a time.
CellGround WideGround() {
  OccupancyGrid grid = MakeGrid(160, 150, CellState::kFree);
  for (const auto& [column, row] : {std::pair(50, 60), {100, 90}, {75, 30}}) {
    for (int i = 0; i < 5; ++i) grid.cells[grid.index(column + i, row + i % 2)] = CellState::kBlocked;
  }
  return CellGround(std::move(grid), {});
}

TEST(GridManifold, IsTheSameForAnyNumberOfThreads) {
  ManifoldOptions options{.base = {60, 70}, .length_m = 150};
  const GridManifold one = GridManifold::Build(WideGround(), options);
  for (const std::size_t threads : {2, 5}) {
    options.parallel = Threads(threads);
    const GridManifold many = GridManifold::Build(WideGround(), options);
    ASSERT_EQ(many.pages(), one.pages());
    for (std::uint32_t page = 0; page < one.pages(); ++page) {
      ASSERT_EQ(many.patch(page), one.patch(page));
      ASSERT_EQ(many.vertices(page), one.vertices(page));
      for (int cell = 0; cell < 64; ++cell) {
        if (!one.Has({page, cell})) continue;
        ASSERT_EQ(many.distance({page, cell}), one.distance({page, cell}));
      }
    }
    EXPECT_EQ(many.Count().edges, one.Count().edges);
  }
}

/// FNV-1a.
std::uint64_t HashOf(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  return hash;
}

/// What a manifold is as a file, and the distances to a goal on it.
std::pair<std::uint64_t, std::uint64_t> HashesOf(const ManifoldOptions& options) {
  const GridManifold manifold = GridManifold::Build(WideGround(), options);
  const ManifoldGoalField field(manifold, {100, 80});
  std::string distances;
  for (std::uint32_t page = 0; page < manifold.pages(); ++page) {
    for (int cell = 0; cell < 64; ++cell) {
      if (manifold.Has({page, cell})) distances += std::to_string(field.distance({page, cell})) + " ";
    }
  }
  return {HashOf(ManifoldFile::Write(manifold, 0)), HashOf(distances)};
}

/// A change that changes these numbers changes what files of manifolds mean: their version must change with them.
TEST(GridManifold, IsTheSameToTheBitAsEver) {
  const auto expect = [](Connectivity connectivity, std::pair<std::uint64_t, std::uint64_t> golden) {
    ManifoldOptions options{.base = {60, 70}, .length_m = 130, .connectivity = connectivity};
    for (const std::size_t threads : {0U, 0U, 1U, 2U, 5U, 2U}) {
      options.parallel = threads > 0 ? Threads(threads) : ParallelRanges();
      EXPECT_EQ(HashesOf(options), golden) << threads << " threads";
    }
  };
  expect(Connectivity::kFour, {8181716681449764267U, 10883065048094938875U});
  expect(Connectivity::kEight, {13315603337413731346U, 10371406332699898531U});
}

TEST(GridManifold, StopsAtItsBudgetWithAllThatIsNear) {
  ManifoldOptions options{.base = {60, 70}, .length_m = 150};
  const GridManifold whole = GridManifold::Build(WideGround(), options);
  options.max_vertices = 20'000;
  const GridManifold part = GridManifold::Build(WideGround(), options);
  EXPECT_EQ(part.stop(), ManifoldStop::kVertices);
  const ManifoldCounts counts = part.Count();
  EXPECT_LE(counts.vertices, 20'000);
  EXPECT_GT(counts.vertices, 15'000);
  EXPECT_LT(counts.farthest, part.complete_up_to());
  std::int64_t near = 0;
  for (std::uint32_t page = 0; page < whole.pages(); ++page) {
    for (int cell = 0; cell < 64; ++cell) {
      if (whole.Has({page, cell}) && whole.distance({page, cell}) < part.complete_up_to()) ++near;
    }
  }
  EXPECT_EQ(near, counts.vertices);
}

TEST(GridManifold, StopsAtItsBytesAndWhenAsked) {
  ManifoldOptions options{.base = {60, 70}, .length_m = 150};
  options.max_bytes = 1;
  EXPECT_EQ(GridManifold::Build(WideGround(), options).stop(), ManifoldStop::kBytes);
  options.max_bytes = std::int64_t{1} << 40;
  int asked = 0;
  options.keep_going = [&asked] { return ++asked < 30; };
  const GridManifold part = GridManifold::Build(WideGround(), options);
  EXPECT_EQ(part.stop(), ManifoldStop::kAsked);
  EXPECT_EQ(asked, 30);
  EXPECT_GE(part.complete_up_to(), 30 * kStraightStep);
  EXPECT_LT(part.complete_up_to(), part.limit() / 2);
}

TEST(GridManifold, OfATetherBeyondAllNumbersSaysSo) {
  const GridManifold ring = GridManifold::Build(Ground({"...", ".#.", "..."}), Four({0, 0}, 1e7));
  EXPECT_EQ(ring.stop(), ManifoldStop::kDistance);
  EXPECT_EQ(GridManifold::Build(Ground({"...", "..."}), Four({0, 0}, 1e7)).stop(), ManifoldStop::kNone);
}

}  // namespace
}  // namespace tautline
