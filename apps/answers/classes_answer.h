// The question of `classes`, answered: what every face of tautline hands out.
#ifndef APPS_ANSWERS_CLASSES_ANSWER_H_
#define APPS_ANSWERS_CLASSES_ANSWER_H_

#include <optional>
#include <string>

#include "apps/answers/exit_status.h"
#include "apps/answers/json_values.h"
#include "apps/answers/preparation.h"
#include "tautline/base/error.h"
#include "tautline/homotopy/classes.h"
#include "tautline/planners/tether/tether_planner.h"
#include "tautline/scene/scene.h"

namespace tautline {

struct ClassesQuestion {
  std::optional<Point> from;        ///< Default: the tether's base.
  std::optional<Point> to;          ///< Default: the goal.
  ClassOptions options;             ///< Without length and count: up to the tether, 100 at most.
  std::optional<std::string> word;  ///< Only the class of this word.
  bool verify = false;              ///< Check the answer by independent means.
  Preparation preparation = {};     ///< How the world is prepared.
};

struct ClassesAnswer {
  TetherPlanner planner;
  ClassesQuestion question;  ///< With what was left to defaults filled in.
  ClassList list;
  std::string explanation;          ///< Why there is no class, or no complete list; empty otherwise.
  Json json;                        ///< The result as docs/classes.md describes it.
  ExitStatus status = kExitSolved;  ///< kExitInfeasible too where the budget ran out.
  int verified_curves = 0;          ///< How many taut curves were verified.
};

/// Lists classes. Errors: no end is given and the scene has none, a word names an unknown obstacle, and those of
/// PreparePlanner. Throws std::logic_error where the answer fails verification. Cost: see FindClasses.
[[nodiscard]] Expected<ClassesAnswer> AnswerClasses(const Scene& scene, const ClassesQuestion& question);

}  // namespace tautline

#endif  // APPS_ANSWERS_CLASSES_ANSWER_H_
