// The question of `workspace boundary`, answered: what every face of tautline hands out.
#ifndef APPS_ANSWERS_BOUNDARY_ANSWER_H_
#define APPS_ANSWERS_BOUNDARY_ANSWER_H_

#include <optional>
#include <string>
#include <vector>

#include "apps/answers/exit_status.h"
#include "apps/answers/workspace_setup.h"
#include "tautline/planners/cable_workspace/futures.h"

namespace tautline {

struct BoundaryQuestion {
  bool verify = false;  ///< Check the answer by independent means.
};

struct BoundaryAnswer {
  WorkspaceSetup setup;
  tl::expected<WorkspaceBoundary, BoundaryFault> boundary;
  std::vector<LongestCable> longest = {};       ///< By anchor; empty without a boundary.
  std::optional<Futures> futures = {};          ///< Where the scene has futures.
  std::optional<FutureOutcomes> outcomes = {};  ///< What they make of the boundary.
  Json json = {};                               ///< The result as docs/workspace.md describes it.
  ExitStatus status = kExitSolved;
  int verified_curves = 0;  ///< How many taut curves were verified.
};

/// The workspace of the laid cables, now and in every future. Errors: as SetUpWorkspace, LayCables and
/// Futures::Prepare. Throws std::logic_error where the answer fails verification.
[[nodiscard]] Expected<BoundaryAnswer> AnswerBoundary(const Scene& scene, const BoundaryQuestion& question);

}  // namespace tautline

#endif  // APPS_ANSWERS_BOUNDARY_ANSWER_H_
