// A taut curve as it is handed out: its corners and its length.
#ifndef TAUTLINE_HOMOTOPY_TAUT_PATH_H_
#define TAUTLINE_HOMOTOPY_TAUT_PATH_H_

#include "tautline/geometry/polygon.h"
#include "tautline/homotopy/word.h"

namespace tautline {

/// Lengths that agree this closely, as a share of the larger, are equal: rounding of sums must neither forbid a tether
/// that fits exactly nor tell lengths apart that were summed in different orders.
inline constexpr double kLengthTolerance = 1e-9;

/// The one shortest curve of a homotopy class: a polyline that bends only at corners of the free space, around the
/// obstacle at each of them.
struct TautPath {
  Polyline points;    ///< From start to end; at least one point (start == end and length 0 when it is that alone).
  double length = 0;  ///< Metres.
  Word word;          ///< The ray word of its class.
};

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_TAUT_PATH_H_
