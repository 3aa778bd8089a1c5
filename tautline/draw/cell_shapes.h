// Sets of cells of a grid as shapes of a picture.
#ifndef TAUTLINE_DRAW_CELL_SHAPES_H_
#define TAUTLINE_DRAW_CELL_SHAPES_H_

#include <span>
#include <vector>

#include "tautline/draw/svg_writer.h"
#include "tautline/draw/view.h"
#include "tautline/geometry/occupancy_grid.h"

namespace tautline {

/// Rings in metres as closed curves in pixels.
std::vector<SvgCurve> CurvesOf(std::span<const PolygonWithHoles> polygons, const View& view);

/// The outlines of the marked cells of a grid, as curves in pixels. Requires a mark for every cell. O(cells).
std::vector<SvgCurve> CellCurves(OccupancyGrid grid, const std::vector<bool>& marked, const View& view);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_CELL_SHAPES_H_
