// What a point or a corner sees: triangular expansion over the free mesh.
#ifndef TAUTLINE_HOMOTOPY_VISIBILITY_H_
#define TAUTLINE_HOMOTOPY_VISIBILITY_H_

#include <vector>

#include "tautline/homotopy/corners.h"
#include "tautline/homotopy/free_mesh.h"

namespace tautline {

/// A corner in sight along a line that is tangent there. Sight may graze boundaries and pass along them.
struct Sighting {
  /// The corner that is seen.
  CornerId corner;
  Side tail = Side::kNone;  ///< Where the viewer's own obstacle lies, looking at the corner; kNone for a free point.
  Side head = Side::kNone;  ///< Where the corner's obstacle lies, seen by the viewer.

  /// By corner, then tail, then head.
  friend auto operator<=>(const Sighting&, const Sighting&) = default;
};

/// The corners visible from a place, each once, tangent at the corner. On a vertex, only the sector of the place's
/// triangle sees. O(triangles seen). [Bungiu2014]
std::vector<Sighting> SeeFromPoint(const FreeMesh& mesh, const Corners& corners, Place place);

/// The corners visible from a corner along bitangents, each once. Only the two cones in which a taut curve can leave
/// the corner are searched.
std::vector<Sighting> SeeFromCorner(const FreeMesh& mesh, const Corners& corners, CornerId id);

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_VISIBILITY_H_
