// The picture of deadlocks on a manifold [Igarashi2010, Fig. 12].
#ifndef TAUTLINE_DRAW_DRAW_DEADLOCKS_H_
#define TAUTLINE_DRAW_DRAW_DEADLOCKS_H_

#include <string>

#include "tautline/planners/grid_manifold/deadlocks.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// The picture, as SVG: cells darker the larger the closed share of their classes, stars at contacts that lock the
/// robot in, with the tether to them, and small rings at others, one for each run of contacts. Requires a world with a
/// free space. Deterministic. O(cells + vertices).
std::string DrawDeadlocks(const Scene& scene, const GridManifold& manifold, const DeadlockAreas& areas);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_DEADLOCKS_H_
