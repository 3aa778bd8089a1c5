// The picture of a plan.
#ifndef TAUTLINE_DRAW_DRAW_PLAN_H_
#define TAUTLINE_DRAW_DRAW_PLAN_H_

#include <string>

#include "tautline/planners/tether/plan.h"
#include "tautline/scene/free_space.h"

namespace tautline {

/// The picture, as SVG, of how a robot moves to its goal: its path with arrows, the tether before
/// and after, the cable as laid, and the shorter path that the tether forbids. When there is no
/// plan it shows why: what is blocked, the separate pieces of ground, or where the tether ends.
/// With PlanResult::all, the other classes as numbered lines. `space` is the free space of the
/// scene's world. Deterministic.
std::string DrawPlan(const Scene& scene, const FreeSpace& space, const PlanResult& result);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_PLAN_H_
