// Loose pieces of a region's boundary joined into closed rings.
#ifndef TAUTLINE_PLANNERS_TETHER_CHAIN_RINGS_H_
#define TAUTLINE_PLANNERS_TETHER_CHAIN_RINGS_H_

#include <vector>

#include "tautline/planners/tether/region_ring.h"

namespace tautline {

/// Joins directed pieces, each with the region on its left, end to start. Ends that are no more than `tolerance` metres
/// apart meet; pieces shorter than that are dropped; neighbours on one wall, cut or circle become one piece. Where
/// several pieces start, the sharpest left turn is taken, so that rings touch and never cross. The largest area first.
/// Throws when the pieces do not close. O(n log n).
std::vector<RegionRing> ChainRings(std::vector<RegionPiece> pieces, double tolerance);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_CHAIN_RINGS_H_
