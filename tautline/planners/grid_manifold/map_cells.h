// The cells of a world: those of its map, or a lattice laid over its free space.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_MAP_CELLS_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_MAP_CELLS_H_

#include <optional>

#include "tautline/base/error.h"
#include "tautline/planners/grid_manifold/cell_ground.h"
#include "tautline/scene/free_space.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// How a world becomes cells.
struct MapCellsOptions {
  std::optional<double> resolution_m;  ///< The side of a cell; absent: that of the map's own cells.
  bool unknown_free = false;           ///< Unknown cells of a map are free.
};

/// The ground of a world in cells. A cell is blocked when blocked ground reaches into it by more than a
/// millionth of its side; ground that only touches it leaves it free. Without `resolution_m`, and for one that the map
/// has anyway, the cells are those of the map; a clearance and obstacles beside the map block more of them. With
/// another one a lattice starts at the lower left corner of the box around the outline. Errors: a world without map
/// cells and no resolution, a resolution that is not positive and finite, more than kMostGroundCells, or those of
/// BuildFreeSpace. O(cells + length of the boundary in cells).
[[nodiscard]] Expected<CellGround> MakeCellGround(const World& world, const MapCellsOptions& options);

/// Cells that a ground may have.
inline constexpr std::int64_t kMostGroundCells = 400'000'000;

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_MAP_CELLS_H_
