// The free cells of the ground by tiles, and the steps between them, as sets of cells.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_TILE_STEPS_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_TILE_STEPS_H_

#include <cstddef>
#include <vector>

#include "tautline/planners/grid_manifold/cell_ground.h"
#include "tautline/planners/grid_manifold/tile_relaxation.h"

namespace tautline {

/// How a robot steps from cell to cell.
enum class Connectivity { kFour, kEight };

/// The part of the ground that matters: what lies no farther than `limit` from a cell as the crow flies on the grid.
struct TileReach {
  GridCell from;              ///< Where the tether is tied.
  LatticeDistance limit = 0;  ///< The farthest that a vertex may be.
};

/// The cells of a set moved by so many cell numbers. Requires |offset| < 64.
constexpr TileMask Moved(TileMask cells, int offset) { return offset >= 0 ? cells << offset : cells >> -offset; }

/// How much later in the numbering of cells the cell comes that a step leads to, within a tile.
constexpr int OffsetOf(std::size_t direction) { return kTileSide * kStepRows[direction] + kStepColumns[direction]; }

/// The tiles of a ground, row by row from the lower left corner; tiles beyond the reach have no free cells.
class TileSteps {
 public:
  /// Reads the cells within reach. O(tiles + cells within reach).
  TileSteps(const CellGround& ground, Connectivity connectivity, const TileReach& reach);

  /// Tiles in a row.
  int columns() const { return columns_; }
  /// Rows of tiles.
  int rows() const { return rows_; }
  /// The column of a tile.
  int ColumnOf(int tile) const { return tile % columns_; }
  /// Its row.
  int RowOf(int tile) const { return tile / columns_; }
  /// The number that the tile so many columns and rows on has, or -1.
  int Beside(int tile, int columns, int rows) const;

  /// The free cells of a tile.
  TileMask free(int tile) const { return free_[Padded(ColumnOf(tile), RowOf(tile))]; }
  /// By direction, the cells of a tile from which CellGround::CanStep allows a step, also to other tiles.
  TileMoves From(int tile) const;

 private:
  /// There is a ring of blocked tiles around the ground.
  std::size_t Padded(int column, int row) const {
    return static_cast<std::size_t>(row + 1) * static_cast<std::size_t>(columns_ + 2) +
           static_cast<std::size_t>(column + 1);
  }
  void ReadRow(const CellGround& ground, int row, int first, int last);

  Connectivity connectivity_;
  int columns_ = 0, rows_ = 0;
  std::vector<TileMask> free_;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_TILE_STEPS_H_
