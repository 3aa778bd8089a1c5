// The free space as its boundary rings alone tell it: no mesh and no graph, for checks of answers that come from those.
#ifndef TAUTLINE_HOMOTOPY_RING_GROUND_H_
#define TAUTLINE_HOMOTOPY_RING_GROUND_H_

#include <cstddef>
#include <span>
#include <vector>

#include "tautline/homotopy/word.h"
#include "tautline/scene/free_space.h"

namespace tautline {

/// Every question looks at all edges: O(n) for n boundary vertices where nothing else is said.
class RingGround {
 public:
  /// Keeps the free space by reference.
  explicit RingGround(const FreeSpace& space) : space_(space), tolerance_(BoundaryTolerance(space)) {}

  /// The components that hold p or have it on their boundary; where there are none, the nearest within the tolerance of
  /// the boundary.
  std::vector<std::size_t> ComponentsAt(Point p) const;

  /// Whether p is farther from all free ground than the tolerance of the boundary.
  bool IsBlocked(Point p) const;

  /// Whether the segment stays in the closed free space, up to a depth of `depth` metres: it is cut where it meets
  /// boundaries, and the middle of every piece must be free. O(n) per piece.
  bool HoldsSegment(Point a, Point b, double depth) const;

  /// The same with the depth that the engine allows.
  bool HoldsSegment(Point a, Point b) const { return HoldsSegment(a, b, tolerance_); }

  /// Whether the polyline stays in the closed free space, to the last bit, and touches no place where blocked ground
  /// touches, where the way through is not for the points of the line to tell. O(n) per piece and vertex touched.
  bool SurelyHolds(std::span<const Point> polyline) const;

  /// Whether a curve a-b-c bends at b around blocked ground: b is a boundary vertex whose blocked cone lies between the
  /// two arms, on the inner side of the bend.
  bool BendsAroundObstacle(Point a, Point b, Point c) const;

  /// The reduced word by the definition, ray by ray: for each segment the rays between its ends in order of travel.
  Word WordOf(std::span<const Point> curve) const;

 private:
  template <class Visit>
  void ForEachEdge(Visit visit) const;
  bool TouchesMeeting(Point a, Point b) const;

  const FreeSpace& space_;
  double tolerance_;
};

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_RING_GROUND_H_
