#include "tautline/draw/cell_shapes.h"

#include <utility>

#include "tautline/geometry/trace_cells.h"

namespace tautline {

std::vector<SvgCurve> CurvesOf(std::span<const PolygonWithHoles> polygons, const View& view) {
  std::vector<SvgCurve> curves;
  const auto add = [&](const Ring& ring) {
    SvgCurve curve{.start = view.ToPixels(ring[0]), .steps = {}, .closed = true};
    for (std::size_t i = 1; i < ring.size(); ++i) curve.steps.push_back({.to = view.ToPixels(ring[i])});
    curves.push_back(std::move(curve));
  };
  for (const PolygonWithHoles& polygon : polygons) {
    add(polygon.outer);
    for (const Ring& hole : polygon.holes) add(hole);
  }
  return curves;
}

std::vector<SvgCurve> CellCurves(OccupancyGrid grid, const std::vector<bool>& marked, const View& view) {
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    grid.cells[i] = marked[i] ? CellState::kBlocked : CellState::kFree;
  }
  return CurvesOf(TraceBlockedCells(grid), view);
}

}  // namespace tautline
