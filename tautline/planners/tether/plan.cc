#include "tautline/planners/tether/plan.h"

#include "tautline/planners/tether/tether_planner.h"

namespace tautline {

Expected<PlanResult> Plan(const Scene& scene, const PlanOptions& options) {
  if (!scene.tether) {
    return InvalidInput("the scene has no tether: add `tether: {base: [x, y], length: L}`", scene.path);
  }
  if (!scene.goal) return InvalidInput("the scene has no goal: add `goal: [x, y]`", scene.path);
  const auto planner = TetherPlanner::Prepare(scene.world);
  if (!planner) return tl::unexpected(planner.error());
  return planner->Plan(*scene.tether, *scene.goal, options);
}

}  // namespace tautline
