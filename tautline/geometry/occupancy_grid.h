// A grid of square cells, each free, blocked or unknown, as a plain value.
#ifndef TAUTLINE_GEOMETRY_OCCUPANCY_GRID_H_
#define TAUTLINE_GEOMETRY_OCCUPANCY_GRID_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tautline/geometry/point.h"

namespace tautline {

/// What is known of a cell.
enum class CellState : std::uint8_t { kFree, kBlocked, kUnknown };

/// columns x rows square cells. Cell (0, 0) has its lower left corner at `origin`; columns run along the direction
/// `yaw`, rows to the left of it. `cells` holds row 0 first.
struct OccupancyGrid {
  int columns = 0;               ///< Cells along the direction `yaw`.
  int rows = 0;                  ///< Cells to the left of it.
  double cell_m = 1;             ///< The side of a cell, metres.
  Point origin;                  ///< Metres, in the frame of the map.
  double yaw_rad = 0;            ///< Counter-clockwise from the x axis.
  std::vector<CellState> cells;  ///< columns * rows states.

  /// Whether all members are equal.
  friend bool operator==(const OccupancyGrid&, const OccupancyGrid&) = default;

  /// The position of a cell in `cells`. Requires contains(column, row).
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  /// Whether the grid has such a cell.
  bool contains(int column, int row) const { return column >= 0 && column < columns && row >= 0 && row < rows; }
  /// The state of a cell. Requires contains(column, row).
  CellState at(int column, int row) const { return cells[index(column, row)]; }
};

/// A grid whose cells all have one state. Requires columns, rows > 0.
OccupancyGrid MakeGrid(int columns, int rows, CellState state);

/// How many cells have the state. O(cells).
std::size_t CountCells(const OccupancyGrid& grid, CellState state);

/// Every unknown cell turned into `state`. O(cells).
OccupancyGrid ResolveUnknown(OccupancyGrid grid, CellState state);

/// The place of the lattice point (i, j), 0 <= i <= columns, 0 <= j <= rows: the lower left corner of cell (i, j).
/// Without yaw all points of one column have exactly the same x and all of one row the same y; equal lattice points
/// are equal points always.
Point LatticePoint(const OccupancyGrid& grid, int i, int j);

/// The four corners of the grid, counter-clockwise from the lower left one.
std::vector<Point> GridOutline(const OccupancyGrid& grid);

}  // namespace tautline

#endif  // TAUTLINE_GEOMETRY_OCCUPANCY_GRID_H_
