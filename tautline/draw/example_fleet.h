// Fleets and hand-made plans for tests of pictures.
#ifndef TAUTLINE_DRAW_EXAMPLE_FLEET_H_
#define TAUTLINE_DRAW_EXAMPLE_FLEET_H_

#include <utility>
#include <vector>

#include "tautline/draw/example_pictures.h"
#include "tautline/planners/fleet/fleet_plan.h"
#include "tautline/planners/fleet/playback.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// Three robots whose paths cross at A, B and C; each cable line bends around the target of the next robot, as in Fig.
/// 1 of [Zhang2019].
Scene TriangleScene();

/// `count` robots on short paths across each other, with straight cable lines.
Scene CrowdScene(std::size_t count);

/// A plan on straight paths in the open plane: robots `orders[k].first` pass before `orders[k].second` where their
/// paths cross, and wait as long as they must. Orders must not close a circle in time.
FleetPlan HandMadePlan(const FleetGround& ground, const std::vector<std::pair<int, int>>& orders);

/// Robots as the plan has them, with straight cables but for the last frame, whose cables are those of the layout.
std::vector<PlaybackFrame> HandMadeFrames(const FleetGround& ground, const FleetLayout& layout, const FleetPlan& plan,
                                          int count);

/// One picture of every kind of a fleet, for a person to look at.
std::vector<NamedPicture> FleetPictures();

}  // namespace tautline

#endif  // TAUTLINE_DRAW_EXAMPLE_FLEET_H_
