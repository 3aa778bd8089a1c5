// The area that a polygon and a disc share.
#ifndef TAUTLINE_PLANNERS_TETHER_DISC_AREA_H_
#define TAUTLINE_PLANNERS_TETHER_DISC_AREA_H_

#include <span>

#include "tautline/planners/tether/circle_span.h"

namespace tautline {

/// The signed area of the polygon within the disc, square metres, positive for a counter-clockwise ring. Exact but for
/// rounding. O(n).
double AreaInDisc(std::span<const Point> ring, const Disc& disc);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_DISC_AREA_H_
