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
  std::array<LatticeDistance, 64> at;  ///< By cell of the tile.
};

/// Lowers every distance to the least sum of a distance and a way from there within the tile. `open`: the cells with
/// moves are a rectangle with all steps inside of it, and only they have distances. No way between two of its cells is
/// shorter than those inside, which saves most of the time; beyond the rectangle, the distances then mean nothing.
/// Returns the cells whose distance changed.
TileMask RelaxTile(const TileMoves& moves, bool open, bool diagonal, TileDistances& distances);

/// The cells that have a distance. `distances` holds those of a whole tile.
TileMask ReachedCells(const LatticeDistance* distances);

/// What handing distances on across a side changed.
struct HandedOn {
  TileMask lowered = 0;                ///< Cells of the other tile whose distance became less.
  LatticeDistance least = kUnreached;  ///< The least of their distances.
};

/// Lowers the distances `to` of a whole tile by steps across its side from the one with the distances `from`, which is
/// to be left in the straight direction `side`, up to a limit; `diagonal`: also by diagonal steps.
HandedOn HandAcross(int side, bool diagonal, LatticeDistance limit, const LatticeDistance* from, LatticeDistance* to);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_TILE_RELAXATION_H_
