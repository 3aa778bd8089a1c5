// The plane region that a tether reaches: all points whose shortest way from its root is short enough.
#ifndef TAUTLINE_PLANNERS_TETHER_REACH_PLANE_H_
#define TAUTLINE_PLANNERS_TETHER_REACH_PLANE_H_

#include <vector>

#include "tautline/homotopy/taut_space.h"
#include "tautline/planners/tether/region_ring.h"

namespace tautline {

/// The closed region of all points within `length` metres of the root along shortest paths of the free space, as rings.
/// Exact but for rounding: the arcs are arcs. The root counts for all free sectors at its point. O(cells seen) times
/// the number of cells that see the same triangle, where the region ends.
std::vector<RegionRing> ReachPlane(const TautSpace& space, Place root, double length);

/// The distance within which two computed points are one, for lengths up to `length` in this space, metres.
double JoinTolerance(const FreeSpace& space, double length);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_REACH_PLANE_H_
