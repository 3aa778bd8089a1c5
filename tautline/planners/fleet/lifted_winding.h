// How a loop winds about the lifts of a point in the universal cover of the free space.
#ifndef TAUTLINE_PLANNERS_FLEET_LIFTED_WINDING_H_
#define TAUTLINE_PLANNERS_FLEET_LIFTED_WINDING_H_

#include <span>
#include <utility>
#include <vector>

#include "tautline/homotopy/taut_space.h"

namespace tautline {

/// Winding numbers of a loop about the lifts of a point. A lift is named by the obstacle word of a way to it from the
/// first point of the loop. These are the coefficients of the Fox derivative [Fox1953] of the loop's word by the letter
/// of the point. Without obstacles there is one lift, and its word is empty.
class LiftedWinding {
 public:
  /// About `point`; `space` may be null for the plane without obstacles.
  LiftedWinding(const TautSpace* space, Point point) : space_(space), point_(point) {}

  /// Goes along a polyline, from where it came to so far. `sides` says, for each of its points, on which side of a
  /// traveller the point lies where they are the same place; `on_segment` says so for the inside of segments. Exact.
  /// O(log obstacles) for each segment, and the letters crossed.
  void Walk(std::span<const Point> polyline, std::span<const Side> sides, Side on_segment);

  /// The winding number about a lift, counter-clockwise positive.
  int About(const Word& lift) const;

  /// All lifts with a winding number that is not zero.
  std::vector<std::pair<Word, int>> NonZero() const;

 private:
  void Straight(Point from, Point to, int turn);
  int TurnAround(Point before, Point after, Side side) const;
  void Count(int turn);

  const TautSpace* space_;
  Point point_;
  Word prefix_;
  std::vector<std::pair<Word, int>> sums_;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_LIFTED_WINDING_H_
