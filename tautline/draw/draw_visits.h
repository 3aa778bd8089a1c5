// Where a robot was while it learned: a heat map.
#ifndef TAUTLINE_DRAW_DRAW_VISITS_H_
#define TAUTLINE_DRAW_DRAW_VISITS_H_

#include <string>

#include "tautline/planners/contact_free/visit_map.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// The picture, as SVG: cells the darker the oftener they were visited, in steps of doubling or more, and the reference
/// path, which may be empty [Shimada2024, Figs. 8, 9]. Requires a world with a free space, and a tether. Deterministic.
std::string DrawVisits(const Scene& scene, const VisitMap& visits, const Polyline& reference);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_VISITS_H_
