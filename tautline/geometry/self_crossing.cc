#include "tautline/geometry/self_crossing.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tautline/geometry/overlay.h"
#include "tautline/geometry/polygon.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

bool Apart(const Box& a, const Box& b) {
  return a.high.x < b.low.x || b.high.x < a.low.x || a.high.y < b.low.y || b.high.y < a.low.y;
}

/// Whether the direction to p lies strictly within the left turn from a to b, all seen from `apex`.
bool WithinTurn(Point apex, Point a, Point b, Point p) {
  const bool left_of_a = Orientation(apex, a, p) > 0, right_of_b = Orientation(apex, b, p) < 0;
  return Orientation(apex, a, b) > 0 ? left_of_a && right_of_b : left_of_a || right_of_b;
}

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

/// The area that the ring winds around counter-clockwise, however often, in a frame around it.
double AreaOnLeft(const Ring& ring, const Ring& frame) {
  const std::vector<CoverRing> cover{{ring, 0}};
  double area = SignedArea(frame);
  for (const OverlayRing& free : ComputeOverlay(frame, cover, 1).rings) area -= free.area;
  return area;
}

/// Whether the ring winds around every place once in one direction, or not at all.
bool WindsOnce(std::span<const Point> points) {
  constexpr double kRounding = 1e-9;  // Of the overlay's grid, as a share of the squared size.
  Ring ring(points.begin(), points.end());
  const Box box = BoundingBox(ring);
  const double extent = Norm(box.size()), signed_area = SignedArea(ring);
  const Point margin{extent, extent}, low = box.low - margin, high = box.high + margin;
  const Ring frame{low, {high.x, low.y}, high, {low.x, high.y}};
  const double left = AreaOnLeft(ring, frame);
  std::reverse(ring.begin(), ring.end());
  const double right = AreaOnLeft(ring, frame), tolerance = kRounding * extent * extent;
  return std::min(left, right) <= tolerance && std::max(left, right) <= std::fabs(signed_area) + tolerance;
}

/// The ring with a tree of boxes over runs of consecutive edges.
class CrossingSearch {
 public:
  explicit CrossingSearch(std::span<const Point> ring) : ring_(ring) {
    leaves_ = 1;
    while (leaves_ < ring.size()) leaves_ *= 2;
    boxes_.resize(2 * leaves_);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      boxes_[leaves_ + i].Add(ring[i]);
      boxes_[leaves_ + i].Add(At(i + 1));
    }
    for (std::size_t i = leaves_ - 1; i > 0; --i) boxes_[i] = Joined(boxes_[2 * i], boxes_[2 * i + 1]);
  }

  std::optional<EdgePair> Run() {
    Within(1);
    if (found_ || !run_along_ || WindsOnce(ring_)) return found_;
    return run_along_;
  }

 private:
  static Box Joined(Box a, const Box& b) {
    if (b.empty()) return a;
    a.Add(b.low);
    a.Add(b.high);
    return a;
  }

  Point At(std::size_t i) const { return ring_[i % ring_.size()]; }
  Point Before(std::size_t i) const { return ring_[(i + ring_.size() - 1) % ring_.size()]; }

  void Within(std::size_t node) {
    if (node >= leaves_ || found_) return;
    Within(2 * node);
    Within(2 * node + 1);
    Between(2 * node, 2 * node + 1);
  }

  /// All edges under one node against all under another one of the same height.
  void Between(std::size_t a, std::size_t b) {
    if (found_ || boxes_[a].empty() || boxes_[b].empty() || Apart(boxes_[a], boxes_[b])) return;
    if (a >= leaves_) return Compare(a - leaves_, b - leaves_);
    for (const std::size_t i : {2 * a, 2 * a + 1}) {
      for (const std::size_t j : {2 * b, 2 * b + 1}) Between(i, j);
    }
  }

  void Compare(std::size_t i, std::size_t j) {
    const Point a = At(i), b = At(i + 1), c = At(j), d = At(j + 1);
    if (CrossProperly(a, b, c, d) || CrossAtVertex(i, j) || CrossAtVertex(j, i)) found_ = EdgePair{i, j};
  }

  /// Whether the ring passes through edge j at the start of edge i: inside the edge, or at the start of edge j too.
  bool CrossAtVertex(std::size_t i, std::size_t j) {
    const Point apex = At(i), c = At(j), d = At(j + 1);
    if (apex != c && (apex == d || !OnSegment(c, d, apex))) return false;
    const Meeting meeting = Meet(apex, {Before(i), At(i + 1)}, {apex == c ? Before(j) : c, d});
    if (meeting == Meeting::kRunAlong && !run_along_) run_along_ = EdgePair{std::min(i, j), std::max(i, j)};
    return meeting == Meeting::kCross;
  }

  std::span<const Point> ring_;
  std::size_t leaves_ = 1;
  std::vector<Box> boxes_;
  std::optional<EdgePair> found_;
  std::optional<EdgePair> run_along_;  ///< Edges from which the ring runs along itself.
};

}  // namespace

std::optional<EdgePair> FindSelfCrossing(std::span<const Point> ring) {
  if (ring.size() < 4) return std::nullopt;
  return CrossingSearch(ring).Run();
}

}  // namespace tautline
