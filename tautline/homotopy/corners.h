// The reflex corners of the free space: the only places where a taut curve can bend.
#ifndef TAUTLINE_HOMOTOPY_CORNERS_H_
#define TAUTLINE_HOMOTOPY_CORNERS_H_

#include <cstdint>
#include <span>
#include <vector>

#include "tautline/homotopy/free_mesh.h"

namespace tautline {

using CornerId = Index<struct CornerTag>;  ///< A corner, by position.

/// Which side of a directed line the obstacle at a corner lies on, when the line is tangent there.
enum class Side : std::uint8_t { kNone, kLeft, kRight };

/// The other side, as for a traveller in the other direction; kNone stays.
constexpr Side Opposite(Side side) {
  return side == Side::kLeft ? Side::kRight : side == Side::kRight ? Side::kLeft : Side::kNone;
}

/// A boundary vertex with the one free sector there that is wider than a half turn. Where blocked ground touches, the
/// vertex has other sectors besides.
struct Corner {
  VertexId vertex;   ///< Of the mesh.
  Point point;       ///< Where it is.
  Point previous;    ///< The boundary vertex before it, free ground on the left: the end of the sector.
  Point next;        ///< The boundary vertex after it: where the sector starts, counter-clockwise.
  TriangleId first;  ///< The free triangle of the sector at the edge to `next`.

  /// The side of the obstacle for a traveller along the line from `from` through this corner, or kNone when the line
  /// is not tangent here: the obstacle's cone must lie in one closed half plane. Requires from != point.
  Side TangentFrom(Point from) const;
};

/// The corners of a free mesh and the sectors that they own.
class Corners {
 public:
  /// All corners of the mesh, which must be that of `space`. O(n) for n boundary vertices.
  Corners(const FreeSpace& space, const FreeMesh& mesh);

  /// All corners, by CornerId.
  std::span<const Corner> all() const { return corners_; }
  /// A corner.
  const Corner& operator[](CornerId id) const { return corners_[id.index()]; }
  /// How many there are.
  std::size_t size() const { return corners_.size(); }

  /// The corner whose sector holds the free triangle `id` at its vertex i; invalid when that sector is convex.
  CornerId At(TriangleId id, int i) const { return at_[3 * id.index() + static_cast<std::size_t>(i)]; }

 private:
  void Add(const FreeMesh& mesh, Point previous, Point point, Point next, VertexId vertex, TriangleId first);

  std::vector<Corner> corners_;
  std::vector<CornerId> at_;
};

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_CORNERS_H_
