// The question of `workspace pose`, answered: what every face of tautline hands out.
#ifndef APPS_ANSWERS_POSE_ANSWER_H_
#define APPS_ANSWERS_POSE_ANSWER_H_

#include <optional>
#include <string>

#include "apps/answers/exit_status.h"
#include "apps/answers/workspace_setup.h"
#include "tautline/planners/cable_workspace/pose.h"

namespace tautline {

struct PoseQuestion {
  std::optional<Point> at;  ///< Absent: where the cables are laid.
  bool verify = false;      ///< Check the answer by independent means.
};

struct PoseAnswer {
  WorkspaceSetup setup;
  tl::expected<WorkspaceBoundary, BoundaryFault> boundary;
  Point at = {};                  ///< The pose.
  std::optional<Pose> pose = {};  ///< Nothing without a boundary.
  std::string explanation = {};   ///< Why there is no answer; empty when there is one.
  Json json = {};                 ///< The result as docs/workspace.md describes it.
  ExitStatus status = kExitSolved;
  int verified_curves = 0;  ///< How many taut curves were verified.
};

/// The robot at a pose. Errors: as SetUpWorkspace and LayCables; no pose is given and the cables are not laid. Throws
/// std::logic_error where the answer fails verification.
[[nodiscard]] Expected<PoseAnswer> AnswerPose(const Scene& scene, const PoseQuestion& question);

}  // namespace tautline

#endif  // APPS_ANSWERS_POSE_ANSWER_H_
