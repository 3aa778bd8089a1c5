// The picture of what untangling weighs.
#ifndef TAUTLINE_DRAW_DRAW_UNTANGLING_H_
#define TAUTLINE_DRAW_DRAW_UNTANGLING_H_

#include <string>

#include "tautline/draw/svg_writer.h"
#include "tautline/planners/grid_manifold/target_trials.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// The candidates of a state with their scores, as SVG: the ground that the robot can get to, the cable, each candidate
/// with what driving there would leave, and the chosen one with the cable and the ground after it. Requires a world
/// with a free space, a tether, and the grid of the trials. Deterministic. [Igarashi2010, Fig. 11]
std::string DrawUntangling(const Scene& scene, const OccupancyGrid& grid, const TargetTrials& trials);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_UNTANGLING_H_
