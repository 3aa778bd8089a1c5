// Scenes drawn as text, for tests.
#ifndef TAUTLINE_HOMOTOPY_SKETCHED_SCENE_H_
#define TAUTLINE_HOMOTOPY_SKETCHED_SCENE_H_

#include <cctype>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tautline/base/check.h"
#include "tautline/geometry/trace_cells.h"
#include "tautline/homotopy/print_point.h"
#include "tautline/scene/free_space.h"
#include "tautline/scene/scene.h"

namespace tautline {

struct SketchedScene {
  World world;
  std::map<char, Point> marks;  ///< The middles of the cells with a capital letter or a digit.

  Point operator[](char mark) const { return marks.at(mark); }
};

/// The scene that the rows draw, the highest one first. Cells are 1 m wide, the lower left corner is (0, 0), the
/// outline is the rectangle. '.' is free; the cells with one small letter are one obstacle of that name, in the order
/// of the alphabet; a capital letter or a digit marks a free cell. Requires rows of one length.
inline SketchedScene Sketch(const std::vector<std::string_view>& rows) {
  const int height = static_cast<int>(rows.size()), width = static_cast<int>(rows.at(0).size());
  SketchedScene scene;
  std::map<char, OccupancyGrid> cells;
  for (int row = 0; row < height; ++row) {
    const std::string_view text = rows[static_cast<std::size_t>(height - 1 - row)];
    TAUTLINE_CHECK(text.size() == rows[0].size());
    for (int column = 0; column < width; ++column) {
      const char sign = text[static_cast<std::size_t>(column)];
      if (sign == '.') continue;
      if (!std::islower(static_cast<unsigned char>(sign))) {
        scene.marks[sign] = {column + 0.5, row + 0.5};
        continue;
      }
      OccupancyGrid& grid = cells.try_emplace(sign, MakeGrid(width, height, CellState::kFree)).first->second;
      grid.cells[grid.index(column, row)] = CellState::kBlocked;
    }
  }
  scene.world.outline = GridOutline(MakeGrid(width, height, CellState::kFree));
  for (const auto& [name, grid] : cells) {
    const auto polygons = TraceBlockedCells(grid);
    TAUTLINE_CHECK(polygons.size() == 1);
    Obstacle obstacle;
    obstacle.name = name;
    obstacle.polygon = polygons[0];
    scene.world.obstacles.push_back(std::move(obstacle));
  }
  return scene;
}

/// The free space of a sketch.
inline FreeSpace SpaceOf(const SketchedScene& scene) { return BuildFreeSpace(scene.world).value(); }

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_SKETCHED_SCENE_H_
