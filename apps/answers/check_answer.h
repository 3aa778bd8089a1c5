// The question of `fleet check`, answered: what every face of tautline hands out.
#ifndef APPS_ANSWERS_CHECK_ANSWER_H_
#define APPS_ANSWERS_CHECK_ANSWER_H_

#include <string>
#include <vector>

#include "apps/answers/exit_status.h"
#include "apps/answers/fleet_setup.h"
#include "tautline/planners/fleet/check_layout.h"

namespace tautline {

struct CheckAnswer {
  FleetSetup setup;
  LayoutFaults faults = {};                    ///< Empty as well where the lines cannot be cable lines.
  std::vector<std::string> explanations = {};  ///< What is wrong, a sentence for each fault.
  Json json = {};                              ///< The result as docs/fleet.md describes it.
  ExitStatus status = kExitSolved;
};

/// Checks the layout of the scene's cable lines. Errors: those of SetUpFleetLayout; kStopped when `watch` said stop.
[[nodiscard]] Expected<CheckAnswer> AnswerCheck(const Scene& scene, const Watcher& watch = {});

/// A node as `at` and what is there: `start` or `target`, the name of the robot, or `corner`, true.
Json NodeJson(const FleetSetup& setup, FleetNodeId node);

}  // namespace tautline

#endif  // APPS_ANSWERS_CHECK_ANSWER_H_
