#include "tautline/scene/map_world.h"

#include <utility>

#include "tautline/geometry/simplify.h"
#include "tautline/geometry/trace_cells.h"

namespace tautline {

MapWorld WorldFromGrid(OccupancyGrid grid, const SceneOptions& options) {
  MapWorld world;
  world.outline = GridOutline(grid);
  world.source.resolution = grid.cell_m;
  world.source.columns = grid.columns;
  world.source.rows = grid.rows;
  world.source.origin = grid.origin;
  world.source.origin_yaw = grid.yaw_rad;
  world.source.free_cells = CountCells(grid, CellState::kFree);
  world.source.blocked_cells = CountCells(grid, CellState::kBlocked);
  world.source.unknown_cells = CountCells(grid, CellState::kUnknown);
  world.source.simplify = options.simplify;
  const CellState unknown = options.unknown_free ? CellState::kFree : CellState::kBlocked;
  auto polygons = TraceBlockedCells(ResolveUnknown(grid, unknown));
  if (options.simplify > 0) polygons = SimplifyOutwards(polygons, options.simplify);
  for (PolygonWithHoles& polygon : polygons) {
    Obstacle obstacle;
    obstacle.polygon = std::move(polygon);
    obstacle.from_map = true;
    world.obstacles.push_back(std::move(obstacle));
  }
  world.cells = std::move(grid);
  return world;
}

}  // namespace tautline
