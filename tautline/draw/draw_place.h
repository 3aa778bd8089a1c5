// The picture of where to put the winches.
#ifndef TAUTLINE_DRAW_DRAW_PLACE_H_
#define TAUTLINE_DRAW_DRAW_PLACE_H_

#include <string>

#include "tautline/planners/cable_workspace/place.h"

namespace tautline {

/// The best placement with its workspace, and how the best improved from evaluation to evaluation. Deterministic.
std::string DrawPlace(const Scene& scene, const PlacementGround& ground, const PlaceResult& result);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_PLACE_H_
