// A ring prepared for many questions about points and segments.
#ifndef TAUTLINE_GEOMETRY_RING_INDEX_H_
#define TAUTLINE_GEOMETRY_RING_INDEX_H_

#include <cstddef>
#include <span>
#include <vector>

#include "tautline/geometry/polygon.h"

namespace tautline {

/// A tree of boxes over runs of consecutive edges of a ring. What a run does to the winding number of a point outside
/// its box is told by its two ends alone, so a question looks only into the boxes around its point.
class RingIndex {
 public:
  /// Keeps the ring by reference. O(n).
  explicit RingIndex(std::span<const Point> ring);

  /// As WindingNumber. Exact. O(log n) as a rule, O(n) where most boxes hold p.
  Winding WindingAt(Point p) const;

  /// Whether an edge of the ring and the segment ab cross in a point inside both. Exact. O(log n) as a rule and for
  /// each edge whose box meets that of ab.
  bool IsCrossedBy(Point a, Point b) const;

 private:
  Point At(std::size_t i) const { return ring_[i % ring_.size()]; }
  void AddWinding(std::size_t node, Point p, Winding& winding) const;
  bool IsCrossedBy(std::size_t node, Point a, Point b, const Box& box) const;

  std::span<const Point> ring_;
  std::size_t leaves_ =
      1;  ///< A power of two; edge i is node leaves_ + i, and node k is the parent of 2 k and 2 k + 1.
  std::vector<Box> boxes_;  ///< By node; empty where there are no edges.
};

}  // namespace tautline

#endif  // TAUTLINE_GEOMETRY_RING_INDEX_H_
