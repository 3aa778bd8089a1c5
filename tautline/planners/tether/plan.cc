#include "tautline/planners/tether/plan.h"

#include "tautline/planners/tether/tether_planner.h"
#include "tautline/scene/check_tether.h"

namespace tautline {

Expected<PlanResult> Plan(const Scene& scene, const PlanOptions& options) {
  if (const auto checked = RequireTetherAndGoal(scene); !checked) return tl::unexpected(checked.error());
  const auto planner = TetherPlanner::Prepare(scene.world);
  if (!planner) return tl::unexpected(planner.error());
  return planner->Plan(*scene.tether, *scene.goal, options);
}

}  // namespace tautline
