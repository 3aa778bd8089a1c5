#include "tautline/geometry/self_crossing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tautline/geometry/crossing_sweep.h"
#include "tautline/geometry/overlay.h"
#include "tautline/geometry/polygon.h"
#include "tautline/geometry/ring_edges.h"

namespace tautline {
namespace {

bool Apart(const Box& a, const Box& b) {
  return a.high.x < b.low.x || b.high.x < a.low.x || a.high.y < b.low.y || b.high.y < a.low.y;
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

/// A tree of boxes over runs of consecutive edges: much faster than the sweep for boundaries as they are met.
class BoxSearch {
 public:
  explicit BoxSearch(RingEdges& edges) : edges_(edges), steps_left_(kStepsPerEdge * edges.size()) {
    leaves_ = 1;
    while (leaves_ < edges.size()) leaves_ *= 2;
    boxes_.resize(2 * leaves_);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      boxes_[leaves_ + i].Add(edges.At(i));
      boxes_[leaves_ + i].Add(edges.At(i + 1));
    }
    for (std::size_t i = leaves_ - 1; i > 0; --i) boxes_[i] = Joined(boxes_[2 * i], boxes_[2 * i + 1]);
  }

  /// False when most edges have overlapping boxes, and it gave up.
  bool Run() {
    Within(1);
    return steps_left_ > 0 || edges_.crossing();
  }

 private:
  /// Pairs of boxes. Circles, building outlines and traced rasters take 5 to 30.
  static constexpr std::size_t kStepsPerEdge = 100;

  static Box Joined(Box a, const Box& b) {
    if (b.empty()) return a;
    a.Add(b.low);
    a.Add(b.high);
    return a;
  }

  void Within(std::size_t node) {
    if (node >= leaves_ || edges_.crossing()) return;
    Within(2 * node);
    Within(2 * node + 1);
    Between(2 * node, 2 * node + 1);
  }

  /// All edges under one node against all under another one of the same height.
  void Between(std::size_t a, std::size_t b) {
    if (steps_left_ == 0 || edges_.crossing() || boxes_[a].empty() || boxes_[b].empty()) return;
    --steps_left_;
    if (Apart(boxes_[a], boxes_[b])) return;
    if (a >= leaves_) return edges_.Compare(a - leaves_, b - leaves_);
    for (const std::size_t i : {2 * a, 2 * a + 1}) {
      for (const std::size_t j : {2 * b, 2 * b + 1}) Between(i, j);
    }
  }

  RingEdges& edges_;
  std::size_t steps_left_;
  std::size_t leaves_ = 1;
  std::vector<Box> boxes_;
};

}  // namespace

std::optional<EdgePair> FindSelfCrossing(std::span<const Point> ring) {
  if (ring.size() < 4) return std::nullopt;
  RingEdges edges(ring);
  if (!BoxSearch(edges).Run()) SweepForCrossing(edges);
  if (edges.crossing() || !edges.run_along() || WindsOnce(ring)) return edges.crossing();
  return edges.run_along();
}

}  // namespace tautline
