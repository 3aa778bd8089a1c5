// Sight by looking at every boundary edge: the oracle for visibility, for tests only.
#ifndef TAUTLINE_HOMOTOPY_BRUTE_SIGHT_H_
#define TAUTLINE_HOMOTOPY_BRUTE_SIGHT_H_

#include <cstddef>
#include <span>
#include <vector>

#include "tautline/geometry/polygon.h"
#include "tautline/scene/free_space.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// A place from which to look: a point in open free ground, or a boundary point with one of its free sectors.
struct SightNode {
  Point point;
  bool on_boundary = false;
  Point previous;  ///< On the boundary: the point before it, free ground on the left.
  Point next;      ///< On the boundary: the point after it; free ground lies counter-clockwise from here to `previous`.
};

/// Who sees whom in the closed free space, exactly and slowly. Sight may graze boundaries and pass along them, but
/// not slip between two obstacles that touch.
class BruteSight {
 public:
  /// `rings` bound the free ground and have it on their left; they may touch in points and not cross. `points` are
  /// looked from as well; those that are not in the free ground make no node. O(n^2) for n points in all.
  BruteSight(std::span<const Ring> rings, std::span<const Point> points);

  const std::vector<SightNode>& nodes() const { return nodes_; }

  /// The nodes at a point: one in open ground, one per free sector on the boundary, none in blocked ground.
  std::vector<std::size_t> NodesAt(Point p) const;

  /// Whether the open segment between the two nodes, and its ends, lie in the closed free space. O(n).
  bool Sees(std::size_t a, std::size_t b) const;

 private:
  bool PassesThrough(Point p, Point from, Point to) const;
  bool CrossesBoundary(Point a, Point b) const;

  std::vector<SightNode> nodes_;
  std::vector<Point> points_;  ///< All points, sorted, each once.
  std::vector<Ring> rings_;    ///< With all points that lie on them.
};

/// The boundary rings of a free space.
std::vector<Ring> RingsOf(const FreeSpace& space);

/// The same straight from the scene. Requires simple polygons without holes or clearance that do not touch each other
/// or the outline.
std::vector<Ring> RingsOf(const World& world);

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_BRUTE_SIGHT_H_
