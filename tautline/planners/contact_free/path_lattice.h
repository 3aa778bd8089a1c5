// An 8-connected lattice over free ground, with the two ends of a path joined to it.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_PATH_LATTICE_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_PATH_LATTICE_H_

#include <cstdint>

#include "tautline/base/error.h"
#include "tautline/homotopy/taut_space.h"
#include "tautline/planners/contact_free/path_graph.h"

namespace tautline {

/// A graph with the two nodes that paths are asked between.
struct JoinedGraph {
  PathGraph graph;  ///< With the two ends.
  PathNodeId from;  ///< Where paths start.
  PathNodeId to;    ///< Where they end; the same node when both are one point.
};

/// Points that a lattice may have.
inline constexpr std::int64_t kMostLatticePoints = 4'000'000;

/// That a step is positive and gives no more than kMostLatticePoints.
[[nodiscard]] Expected<void> CheckLatticeStep(const TautSpace& space, double step_m);

/// The centres of square cells with sides of `step_m`, from the lower left corner of the world on, that lie in the free
/// space; each is joined to those of its eight neighbours that it reaches straight. The two ends are joined to the
/// points of the four by four cells around them, and to each other where they are no farther apart than two steps.
/// Errors: those of CheckLatticeStep, or an end that is not in the free space.
/// O(points).
[[nodiscard]] Expected<JoinedGraph> BuildPathLattice(const TautSpace& space, Point from, Point to, double step_m);

/// Whether the segment between two places of the closed free space lies in it.
bool IsFreeSegment(const TautSpace& space, Place from, Point to);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_PATH_LATTICE_H_
