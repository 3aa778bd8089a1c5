// The question of `fleet layouts`, answered: what every face of tautline hands out.
#ifndef APPS_ANSWERS_LAYOUTS_ANSWER_H_
#define APPS_ANSWERS_LAYOUTS_ANSWER_H_

#include <string>

#include "apps/answers/exit_status.h"
#include "apps/answers/fleet_setup.h"
#include "tautline/planners/fleet/layouts.h"

namespace tautline {

struct LayoutsQuestion {
  LayoutsOptions options = {};  ///< Which, and how hard to search.
  bool verify = false;          ///< Check each layout by independent means.
};

struct LayoutsAnswer {
  FleetSetup setup;
  LayoutsResult result = {};
  std::string explanation = {};  ///< Why there is no layout; empty when there is one.
  Json json = {};                ///< The result as docs/fleet_layouts.md describes it.
  ExitStatus status = kExitSolved;
  int verified_curves = 0;  ///< How many cable lines were verified.
};

/// Lists the layouts for the starts and targets of the scene; its cable lines are not used. Errors: those of
/// FleetGround::Prepare. Throws std::logic_error where the answer fails verification.
[[nodiscard]] Expected<LayoutsAnswer> AnswerLayouts(const Scene& scene, const LayoutsQuestion& question);

}  // namespace tautline

#endif  // APPS_ANSWERS_LAYOUTS_ANSWER_H_
