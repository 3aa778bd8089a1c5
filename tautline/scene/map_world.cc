#include "tautline/scene/map_world.h"

#include <cstddef>
#include <string>
#include <utility>

#include "tautline/geometry/simplify.h"
#include "tautline/geometry/trace_cells.h"

namespace tautline {

namespace {

/// The corners of a map before it is simplified; tracing them takes a gigabyte.
constexpr std::size_t kMaxTracedCorners = 16'000'000;

}  // namespace

Expected<MapWorld> WorldFromGrid(OccupancyGrid grid, const SceneOptions& options) {
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
  const OccupancyGrid resolved = ResolveUnknown(grid, unknown);
  if (const std::size_t corners = CountTracedCorners(resolved); corners > kMaxTracedCorners) {
    return tl::unexpected<Error>(Error{ErrorCode::kLimitExceeded,
                                       "the boundaries of its cells have " + std::to_string(corners) +
                                           " corners, more than " + std::to_string(kMaxTracedCorners) +
                                           ": remove the noise or scale the map down",
                                       ""});
  }
  auto polygons = TraceBlockedCells(resolved);
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
