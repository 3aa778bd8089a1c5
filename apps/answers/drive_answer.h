// What `drive` answers, for every face.
#ifndef APPS_ANSWERS_DRIVE_ANSWER_H_
#define APPS_ANSWERS_DRIVE_ANSWER_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "apps/answers/exit_status.h"
#include "apps/answers/json_values.h"
#include "tautline/base/error.h"
#include "tautline/planners/grid_manifold/drive.h"
#include "tautline/planners/grid_manifold/drive_trace.h"
#include "tautline/planners/grid_manifold/map_cells.h"
#include "tautline/planners/grid_manifold/target_trials.h"
#include "tautline/scene/scene.h"

namespace tautline {

struct DriveQuestion {
  MapCellsOptions cells;                   ///< How the world becomes cells; a world without a map has cells of 0.1 m.
  int connectivity = 8;                    ///< 4 or 8.
  DriveOptions options;                    ///< All but the deadlocks, which are found here.
  bool prevent_deadlocks = true;           ///< For the extended controller.
  std::vector<Point> goals;                ///< Instead of those of the scene; may be empty.
  double sample_s = 0.5;                   ///< Between the samples of the trace.
  std::size_t candidates = 0;              ///< Also the candidates before this goal, counted from 1; 0: none.
  std::int64_t max_vertices = 50'000'000;  ///< Of the manifold.
  std::int64_t max_bytes = std::int64_t{4} << 30;  ///< Of the manifold.
  Watcher watch;                                   ///< Told what is being done.
};

struct DriveAnswer {  // NOLINT(bugprone-exception-escape): the JSON library moves its values without noexcept.
  std::vector<GoalOutcome> goals;          ///< In order; empty where the drive cannot begin.
  std::vector<DriveFrame> trace;           ///< Empty where the drive cannot begin.
  std::vector<Contact> contacts;           ///< In the order in which they began.
  std::optional<TargetTrials> candidates;  ///< Where they were asked for, and the robot came so far.
  std::optional<OccupancyGrid> grid;       ///< Their cells.
  std::string explanation;                 ///< Why it did not succeed; empty when it did.
  double time_s = 0;                       ///< Of the drive, simulated.
  double driven_m = 0;                     ///< How far the robot drove.
  Json json;                               ///< The result as docs/drive.md describes it.
  ExitStatus status = kExitSolved;
};

/// Drives the scene's robot to its goals: `goals`, else the scene's tasks in order and then its goal. Errors: the scene
/// has no tether or no goal, links are too short, there are fewer goals than `candidates`, or as MakeCellGround and
/// BuildFreeSpace.
[[nodiscard]] Expected<DriveAnswer> AnswerDrive(const Scene& scene, const DriveQuestion& question);

}  // namespace tautline

#endif  // APPS_ANSWERS_DRIVE_ANSWER_H_
