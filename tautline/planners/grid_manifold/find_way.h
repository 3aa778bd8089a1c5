// The shortest open way on a manifold.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_FIND_WAY_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_FIND_WAY_H_

#include <functional>
#include <vector>

#include "tautline/planners/grid_manifold/open_ground.h"

namespace tautline {

/// Where a way is to end.
struct Destination {
  /// How far a vertex is from it at least: never more than by an open way, and from vertex to vertex never less by more
  /// than the step between them. kUnreached: there is no way.
  std::function<LatticeDistance(ManifoldVertex)> remaining;
  std::function<bool(ManifoldVertex)> holds;  ///< Whether a vertex is there.
};

/// That one vertex. The manifold must outlive it.
Destination ToVertex(const GridManifold& manifold, ManifoldVertex target);

/// The vertices of a shortest open way from `start`, which comes first, to the destination; empty where there is none.
/// Of several the same one always. O(vertices open from the start, times the logarithm).
std::vector<ManifoldVertex> FindWay(const OpenGround& open, ManifoldVertex start, const Destination& destination);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_FIND_WAY_H_
