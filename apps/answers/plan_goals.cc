#include "apps/answers/plan_goals.h"

#include <utility>

#include "apps/answers/verification.h"
#include "tautline/planners/tether/verify_plan.h"
#include "tautline/scene/check_tether.h"

namespace tautline {

PlanGoals::PlanGoals(TetherPlanner planner, const Tether& tether, const PlanQuestion& question)
    : planner_(std::make_unique<const TetherPlanner>(std::move(planner))),
      start_(planner_->PrepareStart(tether)),
      values_(planner_->space().free_space()),
      options_(question.options),
      verify_(MustVerify(question.verify)) {}

Expected<PlanGoals> PlanGoals::Prepare(const Scene& scene, const PlanQuestion& question) {
  if (const auto checked = RequireTether(scene); !checked) return tl::unexpected(checked.error());
  auto planner = PreparePlanner(scene, question.preparation);
  if (!planner) return tl::unexpected(planner.error());
  return PlanGoals(std::move(*planner), *scene.tether, question);
}

GoalAnswer PlanGoals::Answer(Point goal) const {
  const PlanResult result = planner_->Plan(start_, goal, options_);
  GoalAnswer answer;
  answer.status = result.status == PlanStatus::kSolved ? kExitSolved : kExitInfeasible;
  Json document = PlanJson(result, options_.all, values_);
  if (verify_) {
    const Verification verification = VerifyPlan(*planner_, start_.tether(), goal, result);
    ReportVerification(verification.faults, verification.curves, document);
  }
  // The goal as it was given, not rounded, so that answers can be told apart by it.
  answer.json = {{"command", document["command"]}, {"goal", Json::array({goal.x, goal.y})}};
  document.erase("command");
  for (auto& [key, value] : document.items()) answer.json[key] = std::move(value);
  return answer;
}

}  // namespace tautline
