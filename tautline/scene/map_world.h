// A map turned into a world: outline, obstacles, and where they came from.
#ifndef TAUTLINE_SCENE_MAP_WORLD_H_
#define TAUTLINE_SCENE_MAP_WORLD_H_

#include <optional>
#include <vector>

#include "tautline/base/error.h"
#include "tautline/geometry/occupancy_grid.h"
#include "tautline/scene/scene.h"
#include "tautline/scene/scene_options.h"

namespace tautline {

/// What a map says about the world.
struct MapWorld {
  Ring outline;                        ///< Around the free space, metres.
  std::vector<Obstacle> obstacles;     ///< `name` is empty where the map gives none;
                                       ///< BuildFreeSpace calls those o1, o2, ... by position.
  MapSource source;                    ///< Where it came from.
  std::optional<OccupancyGrid> cells;  ///< Of a map of cells; unknown cells as they stand in the map.
};

/// The world of a map of cells: the border of the map is the outline, the 8-connected components of its blocked cells
/// are the obstacles (TraceBlockedCells); unknown cells are blocked unless options.unknown_free; options.simplify > 0
/// makes the boundaries simpler (SimplifyOutwards). The caller fills in path and kind of `source`. Errors:
/// kLimitExceeded when the boundaries have more than 16 million corners, as noise has. O(cells).
[[nodiscard]] Expected<MapWorld> WorldFromGrid(OccupancyGrid grid, const SceneOptions& options);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_MAP_WORLD_H_
