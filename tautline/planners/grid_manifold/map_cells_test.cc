#include "tautline/planners/grid_manifold/map_cells.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tautline/base/test_scale.h"
#include "tautline/homotopy/sketched_scene.h"
#include "tautline/homotopy/taut_space.h"
#include "tautline/planners/grid_manifold/manifold_oracle.h"
#include "tautline/scene/map_world.h"

namespace tautline {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> RowsOf(const CellGround& ground) {
  std::vector<std::string> rows;
  for (int row = ground.rows() - 1; row >= 0; --row) {
    std::string& text = rows.emplace_back();
    for (int column = 0; column < ground.columns(); ++column) text += ground.IsFree({column, row}) ? '.' : '#';
  }
  return rows;
}

TEST(MapCells, OfObstaclesAlongCellsAreTheirs) {
  const auto sketch = Sketch({"......",  //
                              ".aa...",  //
                              ".aa.b.",  //
                              "......"});
  const auto ground = MakeCellGround(sketch.world, {.resolution_m = 1}).value();
  EXPECT_THAT(RowsOf(ground), ElementsAre("......", ".##...", ".##.#.", "......"));
  EXPECT_THAT(ground.names(), ElementsAre("a", "b"));
}

TEST(MapCells, AreBlockedByWhatReachesIntoThem) {
  auto sketch = Sketch({"......",  //
                        ".aa...",  //
                        "....b.",  //
                        "......"});
  sketch.world.clearance = 0.01;
  const auto ground = MakeCellGround(sketch.world, {.resolution_m = 1});
  // The clearance reaches into every cell beside an obstacle or the wall.
  EXPECT_THAT(RowsOf(ground.value()), ElementsAre("######", "######", "######", "######"));
  sketch.world.clearance = 0;
  EXPECT_THAT(RowsOf(MakeCellGround(sketch.world, {.resolution_m = 2}).value()), ElementsAre("##.", "..#"));
}

TEST(MapCells, NeedASide) {
  const auto sketch = Sketch({"..", ".."});
  EXPECT_THAT(MakeCellGround(sketch.world, {}).error().message, HasSubstr("--resolution"));
  EXPECT_FALSE(MakeCellGround(sketch.world, {.resolution_m = 0}));
  EXPECT_EQ(MakeCellGround(sketch.world, {.resolution_m = 1e-9}).error().code, ErrorCode::kLimitExceeded);
}

World WorldOf(const OccupancyGrid& grid) {
  MapWorld map = WorldFromGrid(grid, {}).value();
  World world;
  world.outline = map.outline;
  world.obstacles = map.obstacles;
  for (Obstacle& obstacle : world.obstacles) obstacle.from_map = true;
  world.cells = map.cells;
  return world;
}

/// The shortest way from the base to a vertex, along falling distances.
Polyline WayTo(const GridManifold& manifold, ManifoldVertex v) {
  Polyline way{manifold.ground().CentreOf(manifold.CellOf(v))};
  while (manifold.distance(v) > 0) {
    for (int d = 0; d < kDirections; ++d) {
      const auto to = manifold.Step(v, d);
      if (!to || manifold.distance(*to) != manifold.distance(v) - StepLength(d)) continue;
      v = *to;
      break;
    }
    way.insert(way.begin(), manifold.ground().CentreOf(manifold.CellOf(v)));
  }
  return way;
}

/// Distances on the grid are at least the taut length of the class, and at most what a lattice adds: 8.24 %, and about
/// a cell at each bend, since the grid keeps to the middles of cells where a taut curve touches corners.
TEST(MapCells, GiveTheLengthsOfTautCurvesButForTheLattice) {
  std::size_t compared = 0;
  double worst = 0;
  for (std::int64_t seed = 0; seed < ScaledTestCount(60); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    ManifoldOptions options{.length_m = 9};
    OccupancyGrid grid = RandomGround(rng, options.base).grid();
    grid.cell_m = 1;
    const World world = WorldOf(grid);
    const auto space = BuildFreeSpace(world);
    if (!space) continue;
    const TautSpace taut_space(*space);
    const auto ground = MakeCellGround(world, {});
    ASSERT_TRUE(ground);
    const GridManifold manifold = GridManifold::Build(*ground, options);
    for (std::uint32_t page = 0; page < manifold.pages(); page += 3) {
      for (int cell = static_cast<int>(page % 7); cell < 64; cell += 7) {
        const ManifoldVertex v{page, cell};
        if (!manifold.Has(v)) continue;
        const Shortened taut = Shorten(taut_space, WayTo(manifold, v));
        ASSERT_FALSE(taut.departure);
        const double length = manifold.DistanceM(v), bends = static_cast<double>(taut.path.points.size()) - 2;
        ASSERT_GE(length, taut.path.length * (1 - 1e-9));
        ASSERT_LE(length, 1.0824 * taut.path.length + std::max(0.0, bends) + 1e-9);
        if (bends <= 0 && taut.path.length > 0) worst = std::max(worst, length / taut.path.length);
        ASSERT_EQ(ToString(manifold.WordOf(v), ground->names()), ToString(taut.path.word, NamesOf(*space)));
        ++compared;
      }
    }
  }
  EXPECT_GE(compared, static_cast<std::size_t>(ScaledTestCount(100)));
  EXPECT_LE(worst, 1.0824 + 1e-9);
}

}  // namespace
}  // namespace tautline
