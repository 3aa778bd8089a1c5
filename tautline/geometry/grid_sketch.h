// Grids drawn as text, for tests and examples.
#ifndef TAUTLINE_GEOMETRY_GRID_SKETCH_H_
#define TAUTLINE_GEOMETRY_GRID_SKETCH_H_

#include <cstddef>
#include <string_view>
#include <vector>

#include "tautline/base/check.h"
#include "tautline/geometry/occupancy_grid.h"

namespace tautline {

/// The grid that the rows draw, the highest one first: '#' is blocked, '.' free, '?' unknown. Cells are 1 m wide, the
/// lower left corner is (0, 0). Requires rows of one length.
inline OccupancyGrid GridFromSketch(const std::vector<std::string_view>& rows) {
  TAUTLINE_CHECK(!rows.empty());
  const int height = static_cast<int>(rows.size()), width = static_cast<int>(rows[0].size());
  OccupancyGrid grid = MakeGrid(width, height, CellState::kFree);
  for (int row = 0; row < height; ++row) {
    const std::string_view text = rows[static_cast<std::size_t>(height - 1 - row)];
    TAUTLINE_CHECK(text.size() == rows[0].size());
    for (int column = 0; column < width; ++column) {
      const char sign = text[static_cast<std::size_t>(column)];
      TAUTLINE_CHECK(sign == '#' || sign == '.' || sign == '?');
      grid.cells[grid.index(column, row)] = sign == '#'   ? CellState::kBlocked
                                            : sign == '?' ? CellState::kUnknown
                                                          : CellState::kFree;
    }
  }
  return grid;
}

}  // namespace tautline

#endif  // TAUTLINE_GEOMETRY_GRID_SKETCH_H_
