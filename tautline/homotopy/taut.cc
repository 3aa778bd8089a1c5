#include "tautline/homotopy/taut.h"

#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>

#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// One side of the funnel, from the apex (not included) to its tip. It never holds more than `capacity` points between
/// two resets, and its memory is touched only as far as it does.
class Chain {
 public:
  explicit Chain(std::size_t capacity) : memory_(new std::byte[capacity * sizeof(TautPoint)]) { Reset(); }

  bool empty() const { return begin_ == end_; }
  const TautPoint& front() const { return *begin_; }
  const TautPoint& back() const { return end_[-1]; }
  /// The point before the tip; `apex` when the tip is the only one.
  const TautPoint& BeforeBack(const TautPoint& apex) const { return end_ - begin_ >= 2 ? end_[-2] : apex; }

  void Push(const TautPoint& p) { *end_++ = p; }
  void PopBack() { --end_; }
  void PopFront() { ++begin_; }
  /// Forgets the points that were popped in front. Requires that the chain is empty.
  void Reset() { begin_ = end_ = reinterpret_cast<TautPoint*>(memory_.get()); }

  std::span<const TautPoint> points() const { return {begin_, end_}; }

 private:
  // Bytes, since an array of points would be set to zero first. Copies of points begin to live in it as they come.
  static_assert(std::is_trivially_copyable_v<TautPoint>);
  std::unique_ptr<std::byte[]> memory_;
  TautPoint* begin_;
  TautPoint* end_;
};

/// The funnel: two inward-convex chains from a common apex to the two ends of the current portal.
class Funnel {
 public:
  Funnel(const TautPoint& start, std::size_t portals) : path_{start}, left_(portals + 1), right_(portals + 1) {}

  void AddRight(const TautPoint& p) {
    while (!right_.empty() && Orientation(right_.BeforeBack(path_.back()).point, right_.back().point, p.point) >= 0) {
      right_.PopBack();
    }
    if (right_.empty()) {
      right_.Reset();
      while (!left_.empty() && Orientation(path_.back().point, left_.front().point, p.point) > 0) {
        path_.push_back(left_.front());
        left_.PopFront();
      }
      if (left_.empty()) left_.Reset();
    }
    right_.Push(p);
  }

  void AddLeft(const TautPoint& p) {
    while (!left_.empty() && Orientation(left_.BeforeBack(path_.back()).point, left_.back().point, p.point) <= 0) {
      left_.PopBack();
    }
    if (left_.empty()) {
      left_.Reset();
      while (!right_.empty() && Orientation(path_.back().point, right_.front().point, p.point) < 0) {
        path_.push_back(right_.front());
        right_.PopFront();
      }
      if (right_.empty()) right_.Reset();
    }
    left_.Push(p);
  }

  /// The taut points from the start to `end`.
  std::vector<TautPoint> Finish(const TautPoint& end) {
    AddRight(end);
    path_.insert(path_.end(), right_.points().begin(), right_.points().end());
    return std::move(path_);
  }

 private:
  std::vector<TautPoint> path_;  ///< The part that is settled; its last point is the apex.
  Chain left_, right_;
};

/// Drops repeated points and straight turns, which arise where the curve starts or ends on a vertex or grazes one.
void DropStraight(std::vector<TautPoint>& points) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const TautPoint p = points[i];
    if (kept > 0 && points[kept - 1].point == p.point) {
      if (kept > 1) points[kept - 1] = p;
      continue;
    }
    while (kept >= 2 && Orientation(points[kept - 2].point, points[kept - 1].point, p.point) == 0) --kept;
    points[kept++] = p;
  }
  points.resize(kept);
}

}  // namespace

TautCurve PullTaut(const FreeMesh& mesh, const Walk& walk) {
  const auto sleeve = walk.sleeve.triangles();
  Funnel funnel({walk.from, {}}, sleeve.size());
  VertexId left, right;
  for (std::size_t k = 0; k + 1 < sleeve.size(); ++k) {
    const Triangle& here = mesh.triangle(sleeve[k]);
    const int i = here.IndexOf(sleeve[k + 1]);
    // Leaving across the side from Next(i) to Previous(i) with the triangle on its left: Next(i) is on the right.
    const VertexId new_right = here.vertex(Next(i));
    const VertexId new_left = here.vertex(Previous(i));
    if (new_right != right) funnel.AddRight({mesh.point(new_right), new_right});
    if (new_left != left) funnel.AddLeft({mesh.point(new_left), new_left});
    right = new_right;
    left = new_left;
  }
  TautCurve curve;
  curve.points = funnel.Finish({walk.at, {}});
  DropStraight(curve.points);
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    curve.length += Distance(curve.points[i - 1].point, curve.points[i].point);
  }
  return curve;
}

}  // namespace tautline
