// The question of `plan`, answered: what every face of tautline hands out.
#ifndef APPS_ANSWERS_PLAN_ANSWER_H_
#define APPS_ANSWERS_PLAN_ANSWER_H_

#include "apps/answers/exit_status.h"
#include "apps/answers/json_values.h"
#include "apps/answers/preparation.h"
#include "tautline/base/error.h"
#include "tautline/planners/tether/tether_planner.h"
#include "tautline/scene/scene.h"

namespace tautline {

struct PlanQuestion {
  PlanOptions options;
  bool verify = false;           ///< Check the answer by independent means.
  Preparation preparation = {};  ///< How the world is prepared.
};

struct PlanAnswer {
  TetherPlanner planner;
  PlanResult result;
  Json json;                        ///< The result as docs/plan.md describes it.
  ExitStatus status = kExitSolved;  ///< kExitInfeasible too where the budget ran out.
  int verified_curves = 0;          ///< How many taut curves were verified.
};

/// Plans. Errors: the scene has no tether or no goal, and those of PreparePlanner. Throws std::logic_error
/// where the answer fails verification. Cost: see Plan.
[[nodiscard]] Expected<PlanAnswer> AnswerPlan(const Scene& scene, const PlanQuestion& question);

/// The result as docs/plan.md describes it; with `all` its list of classes.
Json PlanJson(const PlanResult& result, bool all, const JsonValues& values);

}  // namespace tautline

#endif  // APPS_ANSWERS_PLAN_ANSWER_H_
