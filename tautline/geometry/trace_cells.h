// The exact outlines of the blocked cells of a grid.
#ifndef TAUTLINE_GEOMETRY_TRACE_CELLS_H_
#define TAUTLINE_GEOMETRY_TRACE_CELLS_H_

#include <cstddef>
#include <vector>

#include "tautline/geometry/occupancy_grid.h"
#include "tautline/geometry/polygon.h"

namespace tautline {

/// The union of the blocked cells as polygons whose edges run along cell sides. Blocked cells that share a side or a
/// corner belong to one polygon (so free space passes through sides only), and each 8-connected component is exactly
/// one polygon: its outer boundary runs counter-clockwise, its holes, the free regions it encloses, clockwise. A ring
/// visits a corner at which two blocked cells meet diagonally twice; otherwise it touches itself nowhere. Corners
/// between collinear cell sides are left out. Unknown cells count as free here (see ResolveUnknown), and so does
/// everything beyond the grid. The polygons are ordered by their first cell, row 0 first. The coordinates are those
/// of LatticePoint. O(cells).
std::vector<PolygonWithHoles> TraceBlockedCells(const OccupancyGrid& grid);

/// The number of points of all rings of TraceBlockedCells, without tracing: what tracing would need. O(cells).
std::size_t CountTracedCorners(const OccupancyGrid& grid);

}  // namespace tautline

#endif  // TAUTLINE_GEOMETRY_TRACE_CELLS_H_
