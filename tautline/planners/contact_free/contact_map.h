// What robot and cable may touch: rectangles, polygons and walls, prepared for millions of questions.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_CONTACT_MAP_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_CONTACT_MAP_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "tautline/geometry/box_index.h"
#include "tautline/geometry/polygon.h"
#include "tautline/geometry/ring_index.h"
#include "tautline/scene/free_space.h"

namespace tautline {

/// Whether the segment from a to b meets the closed box: the clipping parameters of the four sides leave an interval.
/// [Shimada2024, Eq. 8] [LiangBarsky1984]
bool SegmentMeetsBox(Point a, Point b, const Box& box);

/// Blocked ground. Touching counts. Immutable; safe to use from several threads.
class ContactMap {
 public:
  /// The blocked ground of a free space: what is inside of its holes, and all around it. A grid of cells of `cell_m`
  /// metres, larger ones where there would be more than 256 in a row, answers what is far from obstacles. Keeps
  /// nothing of the space. O(n log n) for n vertices, and for each cell about O(1).
  ContactMap(const FreeSpace& space, double cell_m);
  /// Leaves the other one empty.
  ContactMap(ContactMap&&) = default;
  /// Leaves the other one empty.
  ContactMap& operator=(ContactMap&&) = default;

  /// Whether the segment has a point in blocked ground or on its edge: rectangles by clipping, other rings edge by
  /// edge, exactly. O(1) away from obstacles.
  bool SegmentTouches(Point a, Point b) const;

  /// Whether the closed disc has. O(1) away from obstacles.
  bool DiscTouches(Point centre, double radius_m) const;

  /// A distance around p that is surely free, metres; 0 near blocked ground and in it. Less than the distance by at
  /// most one and a half cells. O(1).
  double ClearAround(Point p) const {
    const double column = (p.x - low_.x) * per_m_, row = (p.y - low_.y) * per_m_;
    if (!(column >= 0 && row >= 0 && column < columns_ && row < rows_)) return 0;
    return clear_m_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                    static_cast<std::size_t>(column)];
  }

  /// Whether p is in blocked ground or on its edge, exactly. O(rings whose boxes hold p).
  bool IsBlocked(Point p) const;

  /// Around the free space.
  const Box& box() const { return box_; }

 private:
  /// A boundary of the free space.
  struct Wall {
    Ring ring;
    RingIndex index;  ///< Of `ring`.
    Box box;
    bool around = false;     ///< Free ground is inside.
    bool rectangle = false;  ///< Of axis-parallel sides, around blocked ground: its box.
  };
  /// An edge, by its ring.
  struct Edge {
    Point a, b;
    std::int32_t wall = 0;
  };

  void AddWall(const Ring& ring, bool around);
  void MakeGrid(double cell_m);
  bool IsInBlockedGround(Point p) const;
  double DistanceToEdges(Point p) const;

  Box box_;
  std::vector<Wall> walls_;
  std::vector<Edge> edges_;
  std::optional<BoxIndex> index_;  ///< Over the edges.
  Point low_;
  double per_m_ = 1;
  int columns_ = 0, rows_ = 0;
  std::vector<float> clear_m_;  ///< By cell, row by row.
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_CONTACT_MAP_H_
