#include "tautline/geometry/occupancy_grid.h"

#include <algorithm>
#include <cmath>

#include "tautline/base/check.h"

namespace tautline {

OccupancyGrid MakeGrid(int columns, int rows, CellState state) {
  TAUTLINE_CHECK(columns > 0 && rows > 0);
  OccupancyGrid grid;
  grid.columns = columns;
  grid.rows = rows;
  grid.cells.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), state);
  return grid;
}

std::size_t CountCells(const OccupancyGrid& grid, CellState state) {
  return static_cast<std::size_t>(std::count(grid.cells.begin(), grid.cells.end(), state));
}

OccupancyGrid ResolveUnknown(OccupancyGrid grid, CellState state) {
  std::replace(grid.cells.begin(), grid.cells.end(), CellState::kUnknown, state);
  return grid;
}

Point LatticePoint(const OccupancyGrid& grid, int i, int j) {
  const Point local{i * grid.cell_m, j * grid.cell_m};
  if (grid.yaw_rad == 0) return grid.origin + local;
  const double c = std::cos(grid.yaw_rad), s = std::sin(grid.yaw_rad);
  return grid.origin + Point{c * local.x - s * local.y, s * local.x + c * local.y};
}

std::vector<Point> GridOutline(const OccupancyGrid& grid) {
  return {LatticePoint(grid, 0, 0), LatticePoint(grid, grid.columns, 0), LatticePoint(grid, grid.columns, grid.rows),
          LatticePoint(grid, 0, grid.rows)};
}

}  // namespace tautline
