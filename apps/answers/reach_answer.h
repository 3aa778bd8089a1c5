// What `reach` answers, for every face.
#ifndef APPS_ANSWERS_REACH_ANSWER_H_
#define APPS_ANSWERS_REACH_ANSWER_H_

#include "apps/answers/exit_status.h"
#include "apps/answers/json_values.h"
#include "apps/answers/preparation.h"
#include "tautline/base/error.h"
#include "tautline/planners/tether/reach.h"
#include "tautline/scene/scene.h"

namespace tautline {

struct ReachQuestion {
  ReachOptions options;
  bool verify = false;           ///< Check the answer by independent means.
  Preparation preparation = {};  ///< How the world is prepared.
};

struct ReachAnswer {
  TetherPlanner planner;
  ReachResult result;
  Json json;                        ///< The result as docs/reach.md describes it.
  ExitStatus status = kExitSolved;  ///< kExitInfeasible too where the budget ran out.
  int verified_curves = 0;          ///< How many curves were verified.
};

/// Prepares the world and answers. Errors: the scene has no tether, or as PreparePlanner.
[[nodiscard]] Expected<ReachAnswer> AnswerReach(const Scene& scene, const ReachQuestion& question);

}  // namespace tautline

#endif  // APPS_ANSWERS_REACH_ANSWER_H_
