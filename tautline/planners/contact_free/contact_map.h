// What robot and cable may touch: rectangles, polygons and walls, prepared for millions of questions.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_CONTACT_MAP_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_CONTACT_MAP_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "tautline/geometry/box_index.h"
#include "tautline/geometry/polygon.h"
#include "tautline/scene/free_space.h"

namespace tautline {

/// Whether the segment from a to b meets the closed box: the clipping parameters of the four sides leave an interval.
/// [Shimada2024, Eq. 8] [LiangBarsky1984]
bool SegmentMeetsBox(Point a, Point b, const Box& box);

/// Blocked ground. Touching counts. Immutable; safe to use from several threads.
class ContactMap {
 public:
  /// The blocked ground of a free space: what is inside of the holes, and outside of all. O(n log n) for n vertices,
  /// and a grid of cells of `cell_m` metres, at most 512 in a row.
  explicit ContactMap(const FreeSpace& space, double cell_m);

  /// Whether the segment has a point in blocked ground or on its edge. O(1) away from obstacles.
  bool SegmentTouches(Point a, Point b) const;

  /// Whether the closed disc has. O(1) away from obstacles.
  bool DiscTouches(Point centre, double radius_m) const;

  /// A distance that is surely free around p, metres; zero near obstacles and in them. At most two cells too small.
  double ClearAround(Point p) const;

  /// Whether p is in blocked ground or on its edge.
  bool IsBlocked(Point p) const;

  /// The distance from p to blocked ground, metres; 0 inside. O(1) in the size of the map, as a rule.
  double DistanceFrom(Point p) const;

  /// Around the free space.
  const Box& box() const { return box_; }
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_CONTACT_MAP_H_
