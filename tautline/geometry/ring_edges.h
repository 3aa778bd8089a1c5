// The edges of a ring, and whether it crosses itself where two of them meet. Internal to the geometry folder.
#ifndef TAUTLINE_GEOMETRY_RING_EDGES_H_
#define TAUTLINE_GEOMETRY_RING_EDGES_H_

#include <cstddef>
#include <optional>
#include <span>

#include "tautline/geometry/point.h"
#include "tautline/geometry/self_crossing.h"

namespace tautline {

/// Looks at pairs of edges of a ring, and keeps the first pairs at which it crosses itself and runs along itself.
class RingEdges {
 public:
  /// Refers to the ring. Requires what FindSelfCrossing does.
  explicit RingEdges(std::span<const Point> ring) : ring_(ring) {}

  /// The number of edges, and of points.
  std::size_t size() const { return ring_.size(); }
  /// Where edge i starts, and edge i - 1 ends.
  Point At(std::size_t i) const { return ring_[i < ring_.size() ? i : i - ring_.size()]; }

  /// Looks at a pair of edges, i != j.
  void Compare(std::size_t i, std::size_t j);

  /// The first pair at which the ring crosses itself.
  const std::optional<EdgePair>& crossing() const { return crossing_; }
  /// The first pair from which the ring runs along itself; only all of the ring tells whether that is a crossing.
  const std::optional<EdgePair>& run_along() const { return run_along_; }

 private:
  Point Before(std::size_t i) const { return ring_[(i + ring_.size() - 1) % ring_.size()]; }
  bool CrossAtVertex(std::size_t i, std::size_t j);

  std::span<const Point> ring_;
  std::optional<EdgePair> crossing_;
  std::optional<EdgePair> run_along_;
};

}  // namespace tautline

#endif  // TAUTLINE_GEOMETRY_RING_EDGES_H_
