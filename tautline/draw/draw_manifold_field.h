// The picture of a field to a goal over a manifold.
#ifndef TAUTLINE_DRAW_DRAW_MANIFOLD_FIELD_H_
#define TAUTLINE_DRAW_DRAW_MANIFOLD_FIELD_H_

#include <string>

#include "tautline/planners/grid_manifold/manifold_goal_field.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// The picture, as SVG: an arrow to the next cell from every vertex, thinned out; those of the nearest class of each
/// cell dark, others light; and the way from the base. Requires a world with a free space. Deterministic.
/// O(cells + vertices).
std::string DrawManifoldField(const Scene& scene, const GridManifold& manifold, const ManifoldGoalField& field);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_MANIFOLD_FIELD_H_
