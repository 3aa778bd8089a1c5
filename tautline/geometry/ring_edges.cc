#include "tautline/geometry/ring_edges.h"

#include <algorithm>
#include <utility>

#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

bool Aligned(Point apex, Point a, Point b) { return Orientation(apex, a, b) == 0 && Dot(a - apex, b - apex) > 0; }

enum class Meeting { kTouch, kCross, kRunAlong };

/// How the way a-apex-b meets the way c-apex-d: it passes from one side to the other, stays on one, or they share a
/// direction, and what that means shows elsewhere.
Meeting Meet(Point apex, std::pair<Point, Point> way, std::pair<Point, Point> other) {
  const auto [a, b] = way;
  const auto [c, d] = other;
  if (Aligned(apex, a, c) || Aligned(apex, a, d) || Aligned(apex, b, c) || Aligned(apex, b, d)) {
    return Meeting::kRunAlong;
  }
  if (Aligned(apex, c, d)) return Meeting::kTouch;
  return WithinTurn(apex, c, d, a) != WithinTurn(apex, c, d, b) ? Meeting::kCross : Meeting::kTouch;
}

}  // namespace

void RingEdges::Compare(std::size_t i, std::size_t j) {
  if (crossing_) return;
  const Point a = At(i), b = At(i + 1), c = At(j), d = At(j + 1);
  if (CrossProperly(a, b, c, d) || CrossAtVertex(i, j) || CrossAtVertex(j, i)) {
    crossing_ = EdgePair{std::min(i, j), std::max(i, j)};
  }
}

/// Whether the ring passes through edge j at the start of edge i: inside the edge, or at the start of edge j too.
bool RingEdges::CrossAtVertex(std::size_t i, std::size_t j) {
  const Point apex = At(i), c = At(j), d = At(j + 1);
  if (apex != c && (apex == d || !OnSegment(c, d, apex))) return false;
  const Meeting meeting = Meet(apex, {Before(i), At(i + 1)}, {apex == c ? Before(j) : c, d});
  if (meeting == Meeting::kRunAlong && !run_along_) run_along_ = EdgePair{std::min(i, j), std::max(i, j)};
  return meeting == Meeting::kCross;
}

}  // namespace tautline
