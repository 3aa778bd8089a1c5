// Whether walks between anchors cross: decided by triangles alone.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_SIDE_CROSSING_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_SIDE_CROSSING_H_

#include <cstdint>
#include <utility>
#include <vector>

#include "tautline/homotopy/taut_space.h"

namespace tautline {

/// A walk prepared for many questions whether it crosses others: where it comes into each triangle and leaves it.
class WalkSpots {
 public:
  /// O(n log n) for n triangles.
  WalkSpots(const TautSpace& space, const Walk& walk);

 private:
  friend bool CablesCross(const WalkSpots& a, const WalkSpots& b);
  struct Reading;

  static bool CrossInOneDirection(const Reading& a, const Reading& b);
  static bool CrossAlong(const Reading& a, const Reading& b, std::size_t i, std::size_t k);

  std::vector<TriangleId> triangles_;
  std::vector<std::pair<TriangleId, std::uint32_t>> places_;  ///< In the walk, sorted by triangle.
  std::vector<std::uint8_t> spots_;  ///< Of the entry and the exit of each triangle; 255 where that is unknown.
  double first_along_ = 0;           ///< Of the spot where the walk starts.
  double last_along_ = 0;            ///< And where it ends.
};

/// As below. O(n) for n triangles that are not shared, and O(shared) per shared run.
bool CablesCross(const WalkSpots& a, const WalkSpots& b);

/// Whether the taut curves of two walks cross, rather than touch or share a part. A crossing is one that no deformation
/// within the two classes removes: the walks share triangles, and at the two ends of what they share they part to
/// opposite sides. The ends of walks must lie on the boundary of the free space: there the cover, a disc, has them in
/// one cyclic order, and two curves cross exactly when their ends alternate. An end in the open crosses nothing. With
/// `a` and `b` the same walk: whether it crosses itself. Exact. O(n) expected for n triangles that are not shared, and
/// O(shared) per shared run.
bool CablesCross(const TautSpace& space, const Walk& a, const Walk& b);

/// Whether a walk that ends in this place ends on the boundary, so that it can be said to cross others. O(1).
bool EndsOnBoundary(const TautSpace& space, const Place& place);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_SIDE_CROSSING_H_
