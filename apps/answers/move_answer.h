// The question of `workspace move`, answered: what every face of tautline hands out.
#ifndef APPS_ANSWERS_MOVE_ANSWER_H_
#define APPS_ANSWERS_MOVE_ANSWER_H_

#include <optional>
#include <string>
#include <vector>

#include "apps/answers/exit_status.h"
#include "apps/answers/workspace_setup.h"
#include "tautline/planners/cable_workspace/move.h"

namespace tautline {

struct MoveQuestion {
  std::optional<Point> from;  ///< Absent: where the cables are laid.
  std::optional<Point> to;    ///< Absent: the goal of the scene.
  MoveOptions options = {};   ///< How the robot drives.
  std::optional<double> dt;   ///< Seconds between samples; absent: a 200th of the motion.
  bool verify = false;        ///< Check the answer by independent means.
};

struct MoveAnswer {
  WorkspaceSetup setup;
  tl::expected<WorkspaceBoundary, BoundaryFault> boundary;
  Point from = {};
  Point to = {};
  MoveOptions options = {};
  std::optional<tl::expected<Move, OutsideFault>> move = {};  ///< Nothing without a boundary.
  std::vector<MoveSample> samples = {};                       ///< Of the motion, if there is one.
  std::string explanation = {};                               ///< Why there is none; empty when there is one.
  Json json = {};                                             ///< The result as docs/workspace_move.md describes it.
  ExitStatus status = kExitSolved;
  int verified_curves = 0;  ///< How many taut curves were verified.
};

/// Moves the robot. Errors: as SetUpWorkspace and LayCables; start or goal are not known; an option cannot be meant;
/// more than a million samples. Throws std::logic_error where the answer fails verification.
[[nodiscard]] Expected<MoveAnswer> AnswerMove(const Scene& scene, const MoveQuestion& question);

/// The samples as a table with a line of titles: t, x, y, speed, and for each winch, counted from 1, length, rate,
/// corner_x and corner_y. Numbers as JSON has them.
std::string MoveCsv(const MoveAnswer& answer);

}  // namespace tautline

#endif  // APPS_ANSWERS_MOVE_ANSWER_H_
