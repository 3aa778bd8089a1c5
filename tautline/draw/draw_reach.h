// The picture of where a tether lets its robot go.
#ifndef TAUTLINE_DRAW_DRAW_REACH_H_
#define TAUTLINE_DRAW_DRAW_REACH_H_

#include <string>

#include "tautline/planners/tether/reach.h"
#include "tautline/scene/free_space.h"

namespace tautline {

/// The picture, as SVG, of the ground that a tether reaches, with true arcs where it ends, and one
/// tether that is fully out or the one to the point that was asked about. Where sheets are listed,
/// ground is the darker the more classes reach it. When the base is blocked it shows where. `space`
/// is the free space of the scene's world. Deterministic.
std::string DrawReach(const Scene& scene, const FreeSpace& space, const ReachResult& result);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_REACH_H_
