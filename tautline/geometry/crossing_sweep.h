// A sweep over the edges of a ring. Internal to the geometry folder.
#ifndef TAUTLINE_GEOMETRY_CROSSING_SWEEP_H_
#define TAUTLINE_GEOMETRY_CROSSING_SWEEP_H_

#include "tautline/geometry/ring_edges.h"

namespace tautline {

/// Compares edges until a crossing is found, or all have been compared that meet in a point or could cross.
/// O(n log n), and k^2 for k edges that meet in one point. [Shamos1976]
void SweepForCrossing(RingEdges& edges);

}  // namespace tautline

#endif  // TAUTLINE_GEOMETRY_CROSSING_SWEEP_H_
