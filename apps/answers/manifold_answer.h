// What `manifold` answers, for every face.
#ifndef APPS_ANSWERS_MANIFOLD_ANSWER_H_
#define APPS_ANSWERS_MANIFOLD_ANSWER_H_

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/answers/exit_status.h"
#include "apps/answers/json_values.h"
#include "tautline/base/error.h"
#include "tautline/planners/grid_manifold/deadlocks.h"
#include "tautline/planners/grid_manifold/grid_manifold.h"
#include "tautline/planners/grid_manifold/manifold_goal_field.h"
#include "tautline/planners/grid_manifold/manifold_sheets.h"
#include "tautline/planners/grid_manifold/map_cells.h"
#include "tautline/scene/scene.h"

namespace tautline {

struct ManifoldQuestion {
  MapCellsOptions cells;                           ///< How the world becomes cells.
  std::optional<int> connectivity;                 ///< 4 or 8; absent: 8, and 4 with `literal`.
  bool literal = false;                            ///< The printed construction instead, 4-connected.
  bool sheets = false;                             ///< Also word by word.
  bool field = false;                              ///< Also the field to the scene's goal.
  bool deadlocks = false;                          ///< Also where the tether can lock the robot in.
  std::int64_t max_vertices = 200'000'000;         ///< After which to stop.
  std::int64_t max_bytes = std::int64_t{8} << 30;  ///< After which to stop.
  std::optional<std::string> prepared;             ///< The bytes of a manifold that was saved.
  std::string prepared_path;                       ///< Where they come from, for errors.
  Watcher watch;                                   ///< Told what is being done.
  ParallelRanges parallel;                         ///< Runs ranges in threads.
};

struct ManifoldAnswer {  // NOLINT(bugprone-exception-escape): the JSON library moves its values without noexcept.
  /// Nothing where the base is blocked, and with `literal`; at a place that stays, for what refers to it.
  std::unique_ptr<const GridManifold> manifold;
  std::optional<DeadlockAreas> deadlocks;  ///< With `deadlocks`.
  std::vector<ManifoldSheet> sheets;       ///< With `sheets`.
  std::string explanation;                 ///< Why it is not solved; empty when it is.
  ManifoldCounts counts;                   ///< Of either construction.
  Json json;                               ///< The result as docs/manifold.md describes it.
  ExitStatus status = kExitSolved;         ///< kExitInfeasible where the base is blocked or a budget ran out.
};

/// Builds the manifold of the scene's tether, or reads it, and answers. Errors: the scene has no tether, or no goal for
/// `field`, a connectivity that is neither 4 nor 8, 8 with `literal`, or as MakeCellGround and ManifoldFile::Read.
[[nodiscard]] Expected<ManifoldAnswer> AnswerManifold(const Scene& scene, const ManifoldQuestion& question);

}  // namespace tautline

#endif  // APPS_ANSWERS_MANIFOLD_ANSWER_H_
