// Joining boundaries that nearly touch.
#ifndef TAUTLINE_GEOMETRY_SNAP_VERTICES_H_
#define TAUTLINE_GEOMETRY_SNAP_VERTICES_H_

#include <cstdint>
#include <vector>

#include "tautline/geometry/polygon.h"

namespace tautline {

/// A ring that knows whose it is.
struct SourcedRing {
  Ring points;              ///< Metres; either orientation.
  std::int32_t source = 0;  ///< Its boundary moves onto those of lower numbers.
};

/// A boundary point of `source` that was moved onto the boundary of `onto`.
struct VertexMove {
  std::int32_t source = 0;  ///< Whose point was moved.
  std::int32_t onto = 0;    ///< Whose boundary it lies on now.
  Point from;               ///< Where it was.
  Point to;                 ///< Where it is now.
};

/// Moves boundaries of different sources that come within `tolerance` metres of each other onto one another: a vertex
/// goes to the nearest vertex, or else the nearest edge point, of a source of lower number; an edge is bent to pass
/// through a vertex of a source of lower number. Afterwards both boundaries have the point where they meet as a vertex.
/// Distances are measured before anything moves, so a vertex that follows one that moved itself may travel farther
/// than `tolerance`; a vertex near several sources goes to one of them. Every move is returned. O(n) for n vertices and
/// few encounters.
std::vector<VertexMove> SnapVertices(std::vector<SourcedRing>& rings, double tolerance);

}  // namespace tautline

#endif  // TAUTLINE_GEOMETRY_SNAP_VERTICES_H_
