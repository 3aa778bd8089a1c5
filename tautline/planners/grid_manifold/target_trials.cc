#include "tautline/planners/grid_manifold/target_trials.h"

#include <utility>

#include "tautline/base/check.h"
#include "tautline/planners/grid_manifold/accessible_region.h"
#include "tautline/planners/grid_manifold/goal_drive.h"
#include "tautline/planners/grid_manifold/intermediate_targets.h"

namespace tautline {
namespace {

RegionCells CellsOf(const GridManifold& manifold, const AccessibleRegion& region) {
  RegionCells cells;
  for (const ManifoldVertex v : region.vertices()) cells.push_back(manifold.CellOf(v));
  return cells;
}

bool IsBetter(const TriedTarget& a, const TriedTarget& b) {
  if (a.touched || b.touched) return b.touched && !a.touched;
  if (a.clears || b.clears) return a.clears && !b.clears;
  return a.region.size() > b.region.size();
}

}  // namespace

TargetTrials TryTargets(const GridManifold& manifold, const DriveState& state, Point goal,
                        const DriveOptions& options) {
  const FieldOfGoal field = FindFieldOfGoal(manifold, goal);
  TAUTLINE_CHECK(field.failure == DriveFailure::kNone);
  RobotDriver driver(manifold, options.robot, {});
  TrialBudget budget;
  const GoalVisit visit(driver, goal, *field.field, budget);
  const AccessibleRegion region(driver.Look(state), state.at);
  TargetTrials trials{.goal = goal,
                      .robot = state.cable.robot(),
                      .open = visit.IsWayOpen(state),
                      .cable = state.cable.Shape(),
                      .region = CellsOf(manifold, region),
                      .targets = {},
                      .chosen = {}};
  for (const IntermediateTarget& target : FindIntermediateTargets(region, driver.coarse())) {
    const TargetTrial trial = TryTarget(driver, visit, state, target.vertex);
    trials.targets.push_back({.at = manifold.ground().CentreOf(manifold.CellOf(target.vertex)),
                              .score_m = CellsOf(target.score) * manifold.ground().cell_m(),
                              .clears = trial.visited.has_value(),
                              .touched = trial.touched,
                              .robot = trial.after.cable.robot(),
                              .cable = trial.after.cable.Shape(),
                              .region = CellsOf(manifold, AccessibleRegion(driver.Look(trial.after), trial.after.at))});
    if (!trials.chosen || IsBetter(trials.targets.back(), trials.targets[*trials.chosen])) {
      trials.chosen = trials.targets.size() - 1;
    }
  }
  if (trials.chosen && trials.targets[*trials.chosen].touched) trials.chosen.reset();
  return trials;
}

}  // namespace tautline
