// Where a robot may go to move its cable out of the way [Igarashi2010, Sec. 4.3].
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_INTERMEDIATE_TARGETS_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_INTERMEDIATE_TARGETS_H_

#include <vector>

#include "tautline/planners/grid_manifold/accessible_region.h"

namespace tautline {

/// A candidate.
struct IntermediateTarget {
  ManifoldVertex vertex;      ///< Where to go.
  LatticeDistance score = 0;  ///< The lesser of the distances to the region's centre and to the robot.
};

/// The local maxima of that score over the region, largest first, without those at the robot or at the centre, and
/// without those that are no farther than `apart` from a larger one: the jagged rim of a tether's reach has many. Of
/// neighbours with equal scores, the one that the region met first. O(AccessibleRegion::Centre).
std::vector<IntermediateTarget> FindIntermediateTargets(const AccessibleRegion& region, LatticeDistance apart);

/// All vertices in every `spacing`-th column and row; with 1 all but the robot's own. O(vertices of the region).
std::vector<ManifoldVertex> SampleTargets(const GridManifold& manifold, const AccessibleRegion& region, int spacing);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_INTERMEDIATE_TARGETS_H_
