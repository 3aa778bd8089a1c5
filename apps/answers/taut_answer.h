// The question of `taut`, answered: what every face of tautline hands out.
#ifndef APPS_ANSWERS_TAUT_ANSWER_H_
#define APPS_ANSWERS_TAUT_ANSWER_H_

#include <string>

#include "apps/answers/exit_status.h"
#include "apps/answers/json_values.h"
#include "tautline/base/error.h"
#include "tautline/planners/tether/tether_planner.h"
#include "tautline/scene/scene.h"

namespace tautline {

struct TautQuestion {
  bool verify = false;  ///< Check the answer by independent means.
};

struct TautAnswer {
  TetherPlanner planner;
  TautPath taut;            ///< The laid cable pulled tight; empty when it cannot lie as it is said to.
  std::string explanation;  ///< Why it cannot; empty when it can.
  Json json;                ///< The result as docs/taut.md describes it.
  ExitStatus status = kExitSolved;
  int verified_curves = 0;  ///< How many taut curves were verified.
};

/// Pulls the laid cable tight. Errors: the scene has no tether or no laid cable, and those of TetherPlanner::Prepare.
/// Throws std::logic_error where the answer fails verification.
[[nodiscard]] Expected<TautAnswer> AnswerTaut(const Scene& scene, const TautQuestion& question);

}  // namespace tautline

#endif  // APPS_ANSWERS_TAUT_ANSWER_H_
