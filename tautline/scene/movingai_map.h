// Grid maps of the MovingAI benchmarks [Sturtevant2012].
#ifndef TAUTLINE_SCENE_MOVINGAI_MAP_H_
#define TAUTLINE_SCENE_MOVINGAI_MAP_H_

#include <string>
#include <string_view>

#include "tautline/base/error.h"
#include "tautline/geometry/occupancy_grid.h"

namespace tautline {

/// Reads a `.map` file of type octile. `.`, `G` and `S` are free, every other sign is blocked. A cell is 1 m x 1 m,
/// the lower left corner of the map is (0, 0), and the first row of the text is the highest one. Lines may end in
/// CR LF; empty lines may follow the last row. `file` stands in the errors: kInvalidInput with the line (header, row
/// too short or too long, rows missing or left over), kLimitExceeded above kMaxCells cells. O(length).
[[nodiscard]] Expected<OccupancyGrid> ParseMovingAiMap(std::string_view text, const std::string& file);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_MOVINGAI_MAP_H_
