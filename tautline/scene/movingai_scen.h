// Problems on MovingAI maps: `.scen` files [Sturtevant2012].
#ifndef TAUTLINE_SCENE_MOVINGAI_SCEN_H_
#define TAUTLINE_SCENE_MOVINGAI_SCEN_H_

#include <string>
#include <string_view>
#include <vector>

#include "tautline/base/error.h"
#include "tautline/geometry/point.h"

namespace tautline {

/// A cell as a `.scen` file counts it: column from the left, row from the top, both from 0.
struct ScenCell {
  int column = 0;  ///< From the left.
  int row = 0;     ///< From the top.

  /// Whether column and row are equal.
  friend bool operator==(const ScenCell&, const ScenCell&) = default;
};

/// One line of the file.
struct ScenProblem {
  int bucket = 0;            ///< Of problems of similar length.
  std::string map;           ///< As written.
  int width = 0;             ///< Of the map, cells.
  int height = 0;            ///< Of the map, cells.
  ScenCell start;            ///< Where the path starts.
  ScenCell goal;             ///< Where it ends.
  double octile_length = 0;  ///< Of the shortest path over 8 neighbours that cuts no corners, cells.
};

/// The centre of the cell in the frame of ParseMovingAiMap, metres.
inline Point CellCentre(ScenCell cell, int map_height) {
  return {cell.column + 0.5, static_cast<double>(map_height) - cell.row - 0.5};
}

/// Reads a file of version 1: nine columns parted by tabs or blanks. `file` stands in the errors: kInvalidInput with
/// the line. O(length).
[[nodiscard]] Expected<std::vector<ScenProblem>> ParseMovingAiScen(std::string_view text, const std::string& file);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_MOVINGAI_SCEN_H_
