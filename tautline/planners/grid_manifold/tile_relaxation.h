// Shortest distances within a tile of 8 x 8 cells, by sweeps over rows of eight lanes.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_TILE_RELAXATION_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_TILE_RELAXATION_H_

#include <array>
#include <cstddef>
#include <cstdint>

#include "tautline/planners/grid_manifold/lattice_distance.h"

namespace tautline {

/// Cells along a side of a tile. Cell (column, row) of a tile has the number 8 row + column, row 0 lowest.
inline constexpr int kTileSide = 8;
/// A set of cells of a tile: bit c is cell c.
using TileMask = std::uint64_t;
/// Directions of a step, counter-clockwise from east; even ones are straight. The opposite of d is d ^ 4.
inline constexpr int kDirections = 8;
/// Columns that a step goes east.
inline constexpr std::array<int, kDirections> kStepColumns{1, 1, 0, -1, -1, -1, 0, 1};
/// Rows that a step goes north.
inline constexpr std::array<int, kDirections> kStepRows{0, 1, 1, 1, 0, -1, -1, -1};

/// The length of a step.
constexpr LatticeDistance StepLength(int direction) { return direction % 2 == 0 ? kStraightStep : kDiagonalStep; }

/// By direction, the cells from which a step in it is allowed and stays in the tile. A step back is always allowed.
using TileMoves = std::array<TileMask, kDirections>;

/// The moves of a tile without walls.
TileMoves OpenMoves(bool diagonal);

/// The moves whose two ends lie in a set.
TileMoves MovesWithin(const TileMoves& moves, TileMask cells);

/// One distance per cell.
struct alignas(32) TileDistances {
  std::array<LatticeDistance, 64> at;
};

/// Lowers every distance to the least sum of a distance and a way from there within the tile. `open`: the moves are
/// those of OpenMoves(diagonal); their being so saves half of the time. Returns the cells whose distance changed.
TileMask RelaxTile(const TileMoves& moves, bool open, bool diagonal, TileDistances& distances);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_TILE_RELAXATION_H_
