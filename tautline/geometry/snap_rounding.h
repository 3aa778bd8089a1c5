// Snap rounding: arbitrary segments become segments between grid points that meet only at their ends.
#ifndef TAUTLINE_GEOMETRY_SNAP_ROUNDING_H_
#define TAUTLINE_GEOMETRY_SNAP_ROUNDING_H_

#include <cstdint>
#include <span>
#include <vector>

#include "tautline/geometry/polygon.h"

namespace tautline {

/// A square grid of representable points around a region: coordinates are exact multiples of `spacing`, a power of
/// two.
class SnapGrid {
 public:
  /// The finest grid that keeps all arithmetic on the box exact: about 2^-39 of its extent, or 2^-51 of its greatest
  /// coordinate where that is coarser.
  explicit SnapGrid(const Box& box);

  /// The distance of neighbouring points, metres; a power of two.
  double spacing() const { return spacing_; }
  /// The greatest coordinate of a grid point, counted from the centre of the grid.
  static constexpr std::int64_t kLimit = std::int64_t{1} << 40;

  /// A point of the grid, counted in spacings from its centre.
  struct Node {
    std::int64_t x = 0;  ///< To the right.
    std::int64_t y = 0;  ///< Up.
    /// By x, then y.
    friend constexpr auto operator<=>(const Node&, const Node&) = default;
  };

  /// The nearest grid point. Requires p within kLimit of the centre.
  Node Round(Point p) const;
  /// Where a grid point is, exactly.
  Point ToPoint(Node node) const;

 private:
  double spacing_;
  std::int64_t centre_x_, centre_y_;
};

/// A directed segment between grid nodes.
struct GridSegment {
  SnapGrid::Node from;  ///< Where it starts.
  SnapGrid::Node to;    ///< Where it ends.
};

/// One chain of nodes per segment, from its `from` to its `to`, such that no two edges of the chains cross properly,
/// and every chain stays within one grid spacing of its segment. Nodes lie within 2^40 of the centre. Exact.
/// O(n log n) plus the number of intersections for short segments. [Hobby1999]
std::vector<std::vector<SnapGrid::Node>> SnapRound(std::span<const GridSegment> segments);

}  // namespace tautline

#endif  // TAUTLINE_GEOMETRY_SNAP_ROUNDING_H_
