// Distances of a page between the array that holds them and the tile that they are computed in.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_PAGE_VALUES_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_PAGE_VALUES_H_

#include <algorithm>
#include <cstring>

#include "tautline/planners/grid_manifold/patch_atlas.h"

namespace tautline {

/// Spreads the values of a patch's cells over its tile; other cells are kUnreached.
inline void LoadTile(const PatchAtlas::Shape& shape, const LatticeDistance* values, TileDistances& tile) {
  if (shape.count == kTileSide * kTileSide) {
    std::memcpy(tile.at.data(), values, sizeof tile.at);
    return;
  }
  tile.at.fill(kUnreached);
  for (TileMask cells = shape.cells; cells != 0; cells &= cells - 1) {
    tile.at[static_cast<std::size_t>(__builtin_ctzll(cells))] = *values++;
  }
}

/// The way back.
inline void StoreTile(const PatchAtlas::Shape& shape, const TileDistances& tile, LatticeDistance* values) {
  if (shape.count == kTileSide * kTileSide) {
    std::memcpy(values, tile.at.data(), sizeof tile.at);
    return;
  }
  for (TileMask cells = shape.cells; cells != 0; cells &= cells - 1) {
    *values++ = tile.at[static_cast<std::size_t>(__builtin_ctzll(cells))];
  }
}

/// The cells of a page that have a distance.
inline TileMask ReachedCells(const PatchAtlas::Shape& shape, const LatticeDistance* values) {
  if (shape.count == kTileSide * kTileSide) return ReachedCells(values);
  TileMask reached = 0;
  for (TileMask cells = shape.cells; cells != 0; cells &= cells - 1) {
    if (*values++ != kUnreached) reached |= cells & -cells;
  }
  return reached;
}

/// The cells that crossing from these leads to.
inline TileMask Across(const PatchAtlas::Crossing& crossing, TileMask cells) {
  return Moved(crossing.from & cells, crossing.offset);
}

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_PAGE_VALUES_H_
