// Overlay: what a domain leaves free when many overlapping rings cover parts of it.
#ifndef TAUTLINE_GEOMETRY_OVERLAY_H_
#define TAUTLINE_GEOMETRY_OVERLAY_H_

#include <cstdint>
#include <span>
#include <vector>

#include "tautline/geometry/polygon.h"

namespace tautline {

/// A ring of something that covers the ground where the winding number, summed over the rings of its source, is
/// positive: outer rings run counter-clockwise, holes clockwise. Rings may cross, touch, overlap and repeat.
struct CoverRing {
  Ring points;                  ///< Metres, either orientation has its meaning.
  std::int32_t source = kWall;  ///< Whose ring it is; rings of one source are one thing.

  static constexpr std::int32_t kWall = -1;  ///< The source of rings that belong to the outside.
};

/// One boundary ring of what is left free, with the free ground on its left.
struct OverlayRing {
  Ring points;                ///< No vertex is collinear with its neighbours.
  std::int32_t free = -1;     ///< The free component on its left.
  std::int32_t blocked = -1;  ///< The blocked component on its right.
  double area = 0;            ///< Square metres; positive exactly when the ring runs counter-clockwise.
};

/// The free ground as rings, and what became of the sources.
struct Overlay {
  /// Rings that bound free ground, counter-clockwise when they surround their component. A ring may touch itself or
  /// others in vertices: blocked ground that meets in a point is one component, free ground is not.
  std::vector<OverlayRing> rings;
  std::int32_t free_count = 0;     ///< Free components: 0 .. free_count-1.
  std::int32_t blocked_count = 0;  ///< Blocked components: 0 .. blocked_count-1.
  /// By source, that of its first piece; -1 when it vanished on the grid.
  std::vector<std::int32_t> blocked_of_source;
  std::vector<std::int32_t> source_of_blocked;  ///< By blocked component: the lowest source with a piece in it, or -1.
  std::vector<Point> inside_of_blocked;         ///< By blocked component: a point in its widest part.
  std::int32_t wall = -1;                       ///< The blocked component that holds the outside.
  double grid = 0;                              ///< All vertices are multiples of this spacing, metres.
};

/// The free ground: inside `domain` (non-zero winding, either orientation) and not covered. Every vertex is an input
/// vertex or a crossing, rounded to a grid of about 2^-39 of the extent; on the grid the answer is exact.
/// O(n log n) for n input vertices with O(n) crossings. Requires finite coordinates; sources are 0 .. sources-1.
Overlay ComputeOverlay(const Ring& domain, std::span<const CoverRing> cover, std::int32_t sources);

}  // namespace tautline

#endif  // TAUTLINE_GEOMETRY_OVERLAY_H_
