// What every reader promises, whatever it is fed.
#ifndef FUZZ_CHECK_ANSWER_H_
#define FUZZ_CHECK_ANSWER_H_

#include <cmath>
#include <string>

#include "tautline/base/check.h"
#include "tautline/base/error.h"
#include "tautline/geometry/occupancy_grid.h"
#include "tautline/geometry/trace_cells.h"

namespace tautline::fuzz {

/// An error is one line that says something.
template <class T>
void CheckAnswer(const Expected<T>& answer) {
  if (answer) return;
  const std::string text = ToString(answer.error());
  TAUTLINE_CHECK(!answer.error().message.empty());
  TAUTLINE_CHECK(text.find('\n') == std::string::npos);
}

/// The polygons of the blocked cells cover as much as the cells do.
inline void CheckTrace(const OccupancyGrid& grid) {
  constexpr std::size_t kMostCells = 1 << 16;  // Larger ones only cost time.
  if (grid.cells.size() > kMostCells) return;
  OccupancyGrid unit = grid;
  unit.cell_m = 1;
  unit.origin = {0, 0};
  unit.yaw_rad = 0;
  double area = 0;
  std::size_t corners = 0;
  for (const PolygonWithHoles& polygon : TraceBlockedCells(unit)) {
    area += SignedArea(polygon.outer);
    corners += polygon.outer.size();
    for (const Ring& hole : polygon.holes) {
      area += SignedArea(hole);
      corners += hole.size();
    }
  }
  TAUTLINE_CHECK(corners == CountTracedCorners(unit));
  TAUTLINE_CHECK(std::fabs(area - static_cast<double>(CountCells(unit, CellState::kBlocked))) < 1e-3);
}

}  // namespace tautline::fuzz

#endif  // FUZZ_CHECK_ANSWER_H_
