#include "tautline/planners/grid_manifold/tile_steps.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace tautline {
namespace {

constexpr TileMask kWestColumn = 0x0101010101010101ULL, kEastColumn = kWestColumn << 7;

/// The cells whose neighbour in the east is in a set; `east` is that of the tile there. The others alike.
TileMask EastOf(TileMask cells, TileMask east) { return (cells >> 1 & ~kEastColumn) | (east & kWestColumn) << 7; }
TileMask WestOf(TileMask cells, TileMask west) { return (cells << 1 & ~kWestColumn) | (west & kEastColumn) >> 7; }
TileMask NorthOf(TileMask cells, TileMask north) { return cells >> 8 | north << 56; }
TileMask SouthOf(TileMask cells, TileMask south) { return cells << 8 | south >> 56; }

/// Which of the cells of a row of a tile are free, `count` of them being on the ground.
TileMask FreeBits(const CellState* cells, int count) {
  static_assert(sizeof(CellState) == 1 && static_cast<int>(CellState::kFree) == 0);
  if (count == kTileSide) {
    std::uint64_t all = 0;
    std::memcpy(&all, cells, sizeof all);
    if (all == 0) return 0xff;
  }
  TileMask bits = 0;
  for (int i = 0; i < count; ++i) bits |= static_cast<TileMask>(cells[i] == CellState::kFree) << i;
  return bits;
}

/// The length of the shortest way between cells so far apart if nothing is in between.
std::int64_t OpenWay(std::int64_t columns, std::int64_t rows, Connectivity connectivity) {
  if (connectivity == Connectivity::kFour) return (columns + rows) * kStraightStep;
  const std::int64_t less = std::min(columns, rows), more = std::max(columns, rows);
  return less * kDiagonalStep + (more - less) * kStraightStep;
}

/// How far a cell is from the nearest of a tile's, in one of the two directions.
int Apart(int tile, int cell) {
  return std::max({0, tile * kTileSide - cell, cell - (tile * kTileSide + kTileSide - 1)});
}

}  // namespace

TileSteps::TileSteps(const CellGround& ground, Connectivity connectivity, const TileReach& reach)
    : connectivity_(connectivity),
      columns_((ground.columns() + kTileSide - 1) / kTileSide),
      rows_((ground.rows() + kTileSide - 1) / kTileSide) {
  free_.assign(Padded(columns_, rows_) + 1, 0);
  // Whether a step is allowed depends on cells one step farther than its ends.
  const std::int64_t limit = std::int64_t{reach.limit} + 2 * std::int64_t{kDiagonalStep};
  for (int row = 0; row < rows_; ++row) {
    const auto is_within = [&](int column) {
      return OpenWay(Apart(column, reach.from.column), Apart(row, reach.from.row), connectivity) <= limit;
    };
    const int middle = reach.from.column / kTileSide;
    if (!is_within(middle)) continue;
    int first = middle, last = middle;
    while (first > 0 && is_within(first - 1)) --first;
    while (last + 1 < columns_ && is_within(last + 1)) ++last;
    ReadRow(ground, row, first, last);
  }
}

/// The tiles from `first` to `last` of a row of tiles.
void TileSteps::ReadRow(const CellGround& ground, int row, int first, int last) {
  const OccupancyGrid& grid = ground.grid();
  for (int i = 0; i < kTileSide && row * kTileSide + i < ground.rows(); ++i) {
    const CellState* cells = &grid.cells[grid.index(0, row * kTileSide + i)];
    for (int column = first; column <= last; ++column) {
      const int first_cell = column * kTileSide, count = std::min(kTileSide, ground.columns() - first_cell);
      free_[Padded(column, row)] |= FreeBits(cells + first_cell, count) << (kTileSide * i);
    }
  }
}

int TileSteps::Beside(int tile, int columns, int rows) const {
  const int column = ColumnOf(tile) + columns, row = RowOf(tile) + rows;
  return column < 0 || row < 0 || column >= columns_ || row >= rows_ ? -1 : row * columns_ + column;
}

TileMoves TileSteps::From(int tile) const {
  const std::size_t at = Padded(ColumnOf(tile), RowOf(tile)), row = static_cast<std::size_t>(columns_) + 2;
  const TileMask here = free_[at];
  const TileMask east = EastOf(here, free_[at + 1]), west = WestOf(here, free_[at - 1]);
  const TileMask north = NorthOf(here, free_[at + row]), south = SouthOf(here, free_[at - row]);
  TileMoves moves{here & east, 0, here & north, 0, here & west, 0, here & south, 0};
  if (connectivity_ == Connectivity::kFour) return moves;
  const TileMask east_north = NorthOf(free_[at + 1], free_[at + row + 1]),
                 east_south = SouthOf(free_[at + 1], free_[at - row + 1]),
                 west_north = NorthOf(free_[at - 1], free_[at + row - 1]),
                 west_south = SouthOf(free_[at - 1], free_[at - row - 1]);
  // A diagonal step needs one of the two cells beside it.
  moves[1] = here & EastOf(north, east_north) & (east | north);
  moves[3] = here & WestOf(north, west_north) & (west | north);
  moves[5] = here & WestOf(south, west_south) & (west | south);
  moves[7] = here & EastOf(south, east_south) & (east | south);
  return moves;
}

}  // namespace tautline
