// Does a closed curve cross itself, and where.
#ifndef TAUTLINE_GEOMETRY_SELF_CROSSING_H_
#define TAUTLINE_GEOMETRY_SELF_CROSSING_H_

#include <cstddef>
#include <optional>
#include <span>

#include "tautline/geometry/point.h"

namespace tautline {

/// Two edges of a ring; edge i runs from point i to the next one. first < second.
struct EdgePair {
  std::size_t first = 0;   ///< The edge that comes first on the ring.
  std::size_t second = 0;  ///< The other one.

  /// Whether both edges are the same.
  friend bool operator==(const EdgePair&, const EdgePair&) = default;
};

/// Two edges at which the ring passes from one side of itself to the other, if there are any: they cross in a point
/// inside both, or in a point that is a vertex of one or both, or the ring runs along itself there and comes out on the
/// other side. A ring that touches itself in a point without crossing, or runs back along one of its edges, is not
/// reported. Exact, but for rings that run along themselves, whose windings are compared on the grid of ComputeOverlay.
/// Requires finite points and that no two neighbours are equal.
/// O(n log n), and k^2 for k edges that meet in one point.
std::optional<EdgePair> FindSelfCrossing(std::span<const Point> ring);

}  // namespace tautline

#endif  // TAUTLINE_GEOMETRY_SELF_CROSSING_H_
