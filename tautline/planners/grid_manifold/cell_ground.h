// The ground as cells: which are free, which islands they leave, and where the rays of those run.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_CELL_GROUND_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_CELL_GROUND_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tautline/geometry/occupancy_grid.h"
#include "tautline/homotopy/word.h"

namespace tautline {

/// A cell by its column and row; (0, 0) is the lower left one.
struct GridCell {
  int column = 0;  ///< From the left.
  int row = 0;     ///< From below.

  /// Whether both are equal.
  friend bool operator==(const GridCell&, const GridCell&) = default;
};

/// A name that an island of blocked cells may have: that of an obstacle, and a point inside of it.
struct IslandName {
  std::string name;      ///< As words print it.
  Point representative;  ///< Metres; its upward ray writes the letter.
};

/// Free and blocked cells. Blocked cells that share a side or a corner belong together; those of them that do not
/// reach the border of the grid are islands, the letters of the words. Immutable.
class CellGround {
 public:
  /// The ground of a grid without unknown cells. An island gets the name of the first of `names` whose representative
  /// lies in it, and its ray; one without a name is called "cells1", "cells2", ... in the order of their first cells,
  /// row 0 first, after those with names. O(cells).
  CellGround(OccupancyGrid grid, std::span<const IslandName> names);

  /// The cells as they were given.
  const OccupancyGrid& grid() const { return grid_; }
  /// Cells in a row.
  int columns() const { return grid_.columns; }
  /// Rows of cells.
  int rows() const { return grid_.rows; }
  /// The side of a cell, metres.
  double cell_m() const { return grid_.cell_m; }
  /// How many cells are free.
  std::size_t free_cells() const { return free_cells_; }

  /// Whether the grid has the cell and it is free.
  bool IsFree(GridCell cell) const {
    return grid_.contains(cell.column, cell.row) && grid_.at(cell.column, cell.row) == CellState::kFree;
  }

  /// The names of the islands, by ObstacleId.
  const std::vector<std::string>& names() const { return names_; }

  /// A ray: it crosses the steps between the columns before `column` and `column`, in all rows above `above_row`.
  struct Ray {
    int column = 0;       ///< The column to the right of the ray.
    int above_row = 0;    ///< The row of its island that it starts in.
    double x = 0;         ///< Where it is, in cells: rays between the same columns are crossed in this order.
    ObstacleId obstacle;  ///< Whose ray it is.
  };
  /// The rays between the columns before `column` and `column`, from left to right.
  std::span<const Ray> RaysBefore(int column) const;
  /// The cell of its island that a ray starts in.
  GridCell StartOf(const Ray& ray) const;

  /// The cell that a point lies in; one on a side lies in the cell to the right or above, at the far border of the
  /// grid in the last one. Nothing outside of the grid.
  std::optional<GridCell> CellAt(Point p) const;
  /// The middle of a cell, metres.
  Point CentreOf(GridCell cell) const;

  /// Whether a step of a direction (0 east, counter-clockwise) is allowed: both cells are free, and for a diagonal one
  /// of the two beside it is free too. Between two blocked cells that touch in a corner nothing passes; the corner of a
  /// single one may be grazed.
  bool CanStep(GridCell from, int direction) const;

 private:
  Point LocalOf(Point p) const;

  OccupancyGrid grid_;
  std::size_t free_cells_ = 0;
  std::vector<std::string> names_;
  std::vector<Ray> rays_;                ///< By column, then from left to right.
  std::vector<std::int32_t> first_ray_;  ///< By column; one more at the end.
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_CELL_GROUND_H_
