#include "tautline/planners/grid_manifold/untangler.h"

#include <set>
#include <utility>

#include "tautline/planners/grid_manifold/accessible_region.h"
#include "tautline/planners/grid_manifold/intermediate_targets.h"
#include "tautline/planners/grid_manifold/state_key.h"

namespace tautline {
namespace {

/// The best of a round of candidates.
struct Choice {
  std::optional<TargetTrial> trial;
  std::size_t region = 0;
};

/// Tries the candidates of a state one by one.
Choice Choose(RobotDriver& driver, const GoalVisit& visit, const DriveState& state,
              const std::set<std::uint64_t>& before, int& trials) {
  Choice best;
  for (const IntermediateTarget& target :
       FindIntermediateTargets(AccessibleRegion(driver.Look(state), state.at), driver.coarse())) {
    if (!visit.MayTry()) return {};
    ++trials;
    TargetTrial trial = TryTarget(driver, visit, state, target.vertex);
    if (trial.visited) return {std::move(trial), 0};
    if (trial.touched || before.count(StateKey(trial.after, driver.coarse_m())) > 0) continue;
    if (!visit.KeepsRetreat(trial.after)) continue;
    const std::size_t region = AccessibleRegion(driver.Look(trial.after), trial.after.at).size();
    if (region > best.region) best = {std::move(trial), region};
  }
  return best;
}

}  // namespace

TargetTrial TryTarget(RobotDriver& driver, const GoalVisit& visit, const DriveState& state, ManifoldVertex target) {
  TargetTrial trial{.after = state, .touched = false, .visited = {}};
  double looked_s = state.cable.time_s(), look_after_s = driver.LookAfter();
  const auto look = [&](const DriveState& now) {
    if (!visit.IsWayOpen(now)) return false;
    // Where a visit failed, one from a little farther on most often fails as well.
    look_after_s *= 2;
    trial.visited = visit.Try(now);
    return trial.visited.has_value();
  };
  const LegEnd end = driver.Drive(ToVertex(driver.manifold(), target), trial.after, [&](const DriveState& now) {
    if (now.cable.time_s() < looked_s + look_after_s) return false;
    looked_s = now.cable.time_s();
    return look(now);
  });
  trial.touched = end == LegEnd::kTouched;
  if (end == LegEnd::kThere || end == LegEnd::kBlocked) look(trial.after);
  return trial;
}

UntangleResult Untangle(RobotDriver& driver, const GoalVisit& visit, const DriveState& start, int max_targets) {
  UntangleResult result;
  DriveState state = start;
  std::set<std::uint64_t> before;
  while (result.targets < max_targets) {
    before.insert(StateKey(state, driver.coarse_m()));
    Choice choice = Choose(driver, visit, state, before, result.trials);
    if (!choice.trial) return result;
    ++result.targets;
    if (choice.trial->visited) {
      result.visited = std::move(choice.trial->visited);
      return result;
    }
    state = std::move(choice.trial->after);
  }
  return result;
}

}  // namespace tautline
