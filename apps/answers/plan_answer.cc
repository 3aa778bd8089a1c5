#include "apps/answers/plan_answer.h"

#include <string>
#include <utility>

#include "apps/answers/verification.h"
#include "tautline/planners/tether/verify_plan.h"
#include "tautline/scene/check_tether.h"

namespace tautline {
namespace {

std::string StatusText(PlanStatus status) {
  switch (status) {
    case PlanStatus::kSolved:
      return "solved";
    case PlanStatus::kInfeasible:
      return "infeasible";
    case PlanStatus::kBudgetExceeded:
      return "budget_exceeded";
  }
  return "";
}

/// A motion as JSON: its path, and its tether with the limit.
void AddMotion(const JsonValues& values, const Motion& motion, double limit, Json& json) {
  json["path"] = values.Of(motion.path.points);
  json["length"] = motion.path.length;
  json["path_word"] = values.Of(motion.path.word);
  json["tether"] = values.Of(motion.tether, "taut");
  json["tether"]["limit"] = limit;
}

/// What it took to cross nothing, and the shortest motion where crossings are allowed.
Json CrossingFreeJson(const JsonValues& values, const PlanResult& result) {
  const CrossingFree& facts = *result.crossing_free;
  Json json;
  json["optimal"] = facts.optimal;
  json["bound"] = facts.bound;
  json["classes_examined"] = facts.classes_examined;
  json["around_base"] = facts.around_base;
  json["retreat_length"] = facts.retreat_length;
  if (facts.plain) AddMotion(values, *facts.plain, result.limit, json["plain"]);
  return json;
}

}  // namespace

Json PlanJson(const PlanResult& result, bool all, const JsonValues& values) {
  Json json;
  json["command"] = "plan";
  json["status"] = StatusText(result.status);
  if (result.status != PlanStatus::kSolved) {
    json["reason"] = result.status == PlanStatus::kBudgetExceeded ? "budget_exceeded" : ToString(result.obstruction);
    json["explanation"] = result.explanation;
  }
  if (result.motion) AddMotion(values, *result.motion, result.limit, json);
  if (!result.start.points.empty()) json["start"] = values.Of(result.start, "taut");
  if (result.shortest_tether) {
    json["shortest_tether"] = result.shortest_tether->length;
    json["shortest_tether_class"] = values.Of(*result.shortest_tether, "taut");
  }
  if (result.rejected) AddMotion(values, *result.rejected, result.limit, json["rejected"]);
  if (result.crossing_free) json["crossing_free"] = CrossingFreeJson(values, result);
  if (all) {
    json["all"] = Json::array();
    for (const Motion& motion : result.all) AddMotion(values, motion, result.limit, json["all"].emplace_back());
    json["all_complete"] = result.all_complete;
  }
  return json;
}

Expected<PlanAnswer> AnswerPlan(const Scene& scene, const PlanQuestion& question) {
  if (const auto checked = RequireTetherAndGoal(scene); !checked) return tl::unexpected(checked.error());
  auto planner = PreparePlanner(scene, question.preparation);
  if (!planner) return tl::unexpected(planner.error());
  PlanAnswer answer{.planner = std::move(*planner)};
  answer.result = answer.planner.Plan(*scene.tether, *scene.goal, question.options);
  answer.json = PlanJson(answer.result, question.options.all, JsonValues(answer.planner.space().free_space()));
  answer.status = answer.result.status == PlanStatus::kSolved ? kExitSolved : kExitInfeasible;
  if (MustVerify(question.verify)) {
    const Verification verification = VerifyPlan(answer.planner, *scene.tether, *scene.goal, answer.result);
    answer.verified_curves = ReportVerification(verification.faults, verification.curves, answer.json);
  }
  return answer;
}

}  // namespace tautline
