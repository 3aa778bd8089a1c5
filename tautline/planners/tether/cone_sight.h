// What an eye sees within a cone and a radius, triangle by triangle.
#ifndef TAUTLINE_PLANNERS_TETHER_CONE_SIGHT_H_
#define TAUTLINE_PLANNERS_TETHER_CONE_SIGHT_H_

#include <optional>
#include <vector>

#include "tautline/homotopy/corners.h"
#include "tautline/homotopy/free_mesh.h"
#include "tautline/planners/tether/circle_span.h"

namespace tautline {

/// A directed line through an eye, by two exact points: from the eye to what it sees, or to the eye from where a curve
/// came.
struct SightLine {
  Point tail;
  Point tip;

  /// Exact: +1 when p lies to the left.
  int SideOf(Point p) const;
};

/// The part of a free triangle between two lines of sight: to the left of `right` and to the right of `left`, which
/// are less than a half turn apart. All of it is seen.
struct SightCell {
  TriangleId triangle;
  SightLine right;
  SightLine left;
};

/// All that is seen from a place, within its own sector, as far as the disc about it reaches. Cells overlap in their
/// boundaries only. [Bungiu2014, with a radius]
std::vector<SightCell> SeeAround(const FreeMesh& mesh, Place place, const Disc& disc);

/// A taut turn to come: a curve that came from `from` and touches the corner with the obstacle on side `head`.
struct Turn {
  const Corner* corner = nullptr;
  Side head = Side::kNone;
  Point from;
};

/// All that the corner sees beyond the turn: between the straight continuation and the obstacle's face. These are the
/// points whose taut curve bends last there, having come that way.
std::vector<SightCell> SeeBeyond(const FreeMesh& mesh, const Turn& turn, const Disc& disc);

/// A side of a cell's triangle as far as it lies in the closed cone: fractions of the way from the lesser to the
/// greater of its two ends.
struct SidePart {
  Point low;  ///< The lesser end of the whole side.
  Point high;
  double from = 0;
  double to = 1;
};

/// The part of the side opposite to vertex i in the cone; nothing when that is a point or less.
std::optional<SidePart> PartInCone(const FreeMesh& mesh, const SightCell& cell, int i);

/// The same within the disc, too.
std::optional<SidePart> PartInDisc(const SidePart& part, const Disc& disc);

/// The parts of the disc's circle that lie in the cell. Requires the disc about the eye of the cell.
std::vector<AngleSpan> ArcsIn(const FreeMesh& mesh, const SightCell& cell, const Disc& disc);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_CONE_SIGHT_H_
