// A length that no tour can be below.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_TOUR_BOUND_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_TOUR_BOUND_H_

#include "tautline/base/stop.h"
#include "tautline/planners/cable_workspace/tour_distances.h"

namespace tautline {

/// How hard BoundTour tries.
struct TourBoundOptions {
  double known_length = 0;    ///< Of some tour: the bound approaches it from below, metres.
  int rounds = 1000;          ///< Spanning trees to look at.
  KeepGoing keep_going = {};  ///< Asked before each round; at a no the best bound so far is returned.
};

/// A lower bound of the length of all tours. A tour is a spanning tree in which the start and the end have one
/// neighbour and every task two, so it is no shorter than the least spanning tree. A price on each node, paid once per
/// neighbour, changes all tours by the same sum but not the least tree; prices rise where the tree has too many
/// neighbours and fall where it has too few, by subgradient ascent [HeldKarp1971]. Not below 0; valid but for rounding.
/// O(rounds * nodes^2).
double BoundTour(const TourDistances& distances, const TourBoundOptions& options);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_TOUR_BOUND_H_
