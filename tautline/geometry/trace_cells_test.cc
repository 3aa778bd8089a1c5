#include "tautline/geometry/trace_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/grid_sketch.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

OccupancyGrid RandomGrid(Rng& rng) {
  const int rows = rng.UniformInt(1, 12), columns = rng.UniformInt(1, 12);
  OccupancyGrid grid = MakeGrid(columns, rows, CellState::kFree);
  const double density = rng.Uniform(0.1, 0.9);
  for (CellState& cell : grid.cells) {
    if (rng.Uniform() < density) cell = CellState::kBlocked;
  }
  return grid;
}

/// The oracle: regions of equal cells found by flooding, with or without diagonal steps.
int CountRegions(const OccupancyGrid& grid, CellState state, bool diagonal) {
  std::vector<bool> seen(grid.cells.size());
  int regions = 0;
  for (std::size_t seed = 0; seed < grid.cells.size(); ++seed) {
    if (seen[seed] || grid.cells[seed] != state) continue;
    ++regions;
    std::vector<std::size_t> stack{seed};
    seen[seed] = true;
    while (!stack.empty()) {
      const int column = static_cast<int>(stack.back()) % grid.columns,
                row = static_cast<int>(stack.back()) / grid.columns;
      stack.pop_back();
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          if (!diagonal && dx != 0 && dy != 0) continue;
          if (!grid.contains(column + dx, row + dy)) continue;
          const std::size_t next = grid.index(column + dx, row + dy);
          if (seen[next] || grid.cells[next] != state) continue;
          seen[next] = true;
          stack.push_back(next);
        }
      }
    }
  }
  return regions;
}

/// The same grid inside a rim of free cells.
OccupancyGrid WithRim(const OccupancyGrid& grid) {
  OccupancyGrid rimmed = MakeGrid(grid.columns + 2, grid.rows + 2, CellState::kFree);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      rimmed.cells[rimmed.index(column + 1, row + 1)] = grid.at(column, row);
    }
  }
  return rimmed;
}

int Holes(const std::vector<PolygonWithHoles>& polygons) {
  int holes = 0;
  for (const PolygonWithHoles& polygon : polygons) holes += static_cast<int>(polygon.holes.size());
  return holes;
}

TEST(TraceBlockedCells, OneCell) {
  const auto polygons = TraceBlockedCells(GridFromSketch({"...",  //
                                                          ".#.",  //
                                                          "..."}));
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_EQ(polygons[0].outer.size(), 4u);
  EXPECT_DOUBLE_EQ(SignedArea(polygons[0].outer), 1);
  EXPECT_TRUE(StrictlyInside(polygons[0], {1.5, 1.5}));
}

TEST(TraceBlockedCells, DropsCollinearCorners) {
  const auto polygons = TraceBlockedCells(GridFromSketch({"###.",  //
                                                          "#..."}));
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_EQ(polygons[0].outer.size(), 6u);
}

TEST(TraceBlockedCells, CellsThatMeetAtACornerAreOnePolygon) {
  const auto polygons = TraceBlockedCells(GridFromSketch({".#",  //
                                                          "#."}));
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_EQ(polygons[0].outer.size(), 8u);
  EXPECT_DOUBLE_EQ(SignedArea(polygons[0].outer), 2);
}

TEST(TraceBlockedCells, ARoomIsAHole) {
  const auto polygons = TraceBlockedCells(GridFromSketch({"####",  //
                                                          "#..#",  //
                                                          "#.##",  //
                                                          "####"}));
  ASSERT_EQ(polygons.size(), 1u);
  ASSERT_EQ(polygons[0].holes.size(), 1u);
  EXPECT_DOUBLE_EQ(SignedArea(polygons[0].holes[0]), -3);
}

TEST(TraceBlockedCells, RoomsThatMeetAtACornerAreTwoHoles) {
  const auto polygons = TraceBlockedCells(GridFromSketch({"####",  //
                                                          "#.##",  //
                                                          "##.#",  //
                                                          "####"}));
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_EQ(polygons[0].holes.size(), 2u);
}

TEST(TraceBlockedCells, AnIslandInARoomIsAPolygonOfItsOwn) {
  const auto polygons = TraceBlockedCells(GridFromSketch({"#####",  //
                                                          "#...#",  //
                                                          "#.#.#",  //
                                                          "#...#",  //
                                                          "#####"}));
  ASSERT_EQ(polygons.size(), 2u);
  EXPECT_EQ(Holes(polygons), 1);
}

TEST(TraceBlockedCells, UnknownCellsAreFreeUntilResolved) {
  const OccupancyGrid grid = GridFromSketch({"#?"});
  EXPECT_DOUBLE_EQ(SignedArea(TraceBlockedCells(grid)[0].outer), 1);
  EXPECT_DOUBLE_EQ(SignedArea(TraceBlockedCells(ResolveUnknown(grid, CellState::kBlocked))[0].outer), 2);
}

TEST(TraceBlockedCells, LiesInTheFrameOfTheMap) {
  OccupancyGrid grid = GridFromSketch({"#."});
  grid.cell_m = 0.05;
  grid.origin = {-3, 7};
  grid.yaw_rad = std::numbers::pi / 2;
  const auto polygons = TraceBlockedCells(grid);
  const Box box = BoundingBox(polygons[0].outer);
  EXPECT_NEAR(box.low.x, -3.05, 1e-12);
  EXPECT_NEAR(box.low.y, 7, 1e-12);
  EXPECT_NEAR(box.high.x, -3, 1e-12);
  EXPECT_NEAR(box.high.y, 7.05, 1e-12);
}

TEST(TraceBlockedCells, AgreesWithTheCellsOnRandomGrids) {
  Rng rng(7);
  for (int i = 0; i < ScaledTestCount(2000); ++i) {
    const OccupancyGrid grid = RandomGrid(rng);
    const auto polygons = TraceBlockedCells(grid);
    EXPECT_EQ(static_cast<int>(polygons.size()), CountRegions(grid, CellState::kBlocked, true));
    EXPECT_EQ(Holes(polygons), CountRegions(WithRim(grid), CellState::kFree, false) - 1);
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        int inside = 0;
        for (const PolygonWithHoles& polygon : polygons) {
          inside += StrictlyInside(polygon, {column + 0.5, row + 0.5}) ? 1 : 0;
        }
        ASSERT_EQ(inside, grid.at(column, row) == CellState::kBlocked ? 1 : 0);
      }
    }
  }
}

TEST(TraceBlockedCells, RingsAreOrientedAndHaveNoCollinearVertices) {
  Rng rng(8);
  for (int i = 0; i < ScaledTestCount(500); ++i) {
    for (const PolygonWithHoles& polygon : TraceBlockedCells(RandomGrid(rng))) {
      EXPECT_GT(SignedArea(polygon.outer), 0);
      EXPECT_EQ(DropCollinear(polygon.outer).size(), polygon.outer.size());
      for (const Ring& hole : polygon.holes) EXPECT_LT(SignedArea(hole), 0);
    }
  }
}

}  // namespace
}  // namespace tautline
