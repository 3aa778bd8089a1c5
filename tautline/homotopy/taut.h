// Pulling a class tight: the funnel algorithm.
#ifndef TAUTLINE_HOMOTOPY_TAUT_H_
#define TAUTLINE_HOMOTOPY_TAUT_H_

#include <vector>

#include "tautline/homotopy/cover.h"

namespace tautline {

/// A bend of a taut curve, or one of its two ends.
struct TautPoint {
  /// Where the curve bends or ends.
  Point point;
  VertexId vertex;  ///< Invalid at an end.
};

/// The taut curve of a class, by vertices.
struct TautCurve {
  std::vector<TautPoint> points;  ///< From start to end; one point when they coincide and the curve is trivial.
  double length = 0;              ///< Metres.
};

/// The one shortest curve from walk.from to walk.at in the class of the walk's sleeve. No turn is straight. Exact but
/// for the length. O(n) for n triangles. [LeePreparata1984, Hershberger1994]
TautCurve PullTaut(const FreeMesh& mesh, const Walk& walk);

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_TAUT_H_
