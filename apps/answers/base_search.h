// The search for the best base of the tether, in jobs that can be run anywhere: one for each candidate.
#ifndef APPS_ANSWERS_BASE_SEARCH_H_
#define APPS_ANSWERS_BASE_SEARCH_H_

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "apps/answers/exit_status.h"
#include "apps/answers/part_file.h"
#include "tautline/planners/grid_manifold/best_base.h"
#include "tautline/planners/grid_manifold/map_cells.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// What is asked of a search, besides its scene.
struct BaseQuestion {
  MapCellsOptions cells;                                 ///< How the world becomes cells.
  int connectivity = 8;                                  ///< Or 4.
  BaseObjective objective = BaseObjective::kArea;        ///< What makes a base the best.
  BaseCandidates candidates = BaseCandidates::kLattice;  ///< Where it may be.
  std::optional<double> spacing_m = {};                  ///< Between them; absent: a 20th of the grid's longer side.
  std::int64_t max_vertices = BaseTrialOptions().max_vertices;
  std::int64_t max_bytes = BaseTrialOptions().max_bytes;
};

/// A search that is ready for its jobs.
struct BaseSearch {
  BaseQuestion question;
  CellGround ground;
  std::vector<GridCell> candidates;  ///< A job for each.
  BaseTrialOptions trial;
  PartKind part;  ///< What its parts have in common.

  /// Runs a job. Deterministic; safe to call from several threads.
  BaseTrial Run(std::size_t job) const;
};

/// Errors: the scene has no tether, a spacing below half of a cell, more than a million candidates, or as
/// MakeCellGround.
[[nodiscard]] Expected<BaseSearch> PrepareBaseSearch(const Scene& scene, const BaseQuestion& question);

/// A part: finished trials with what they belong to, sorted by job.
Json BasePartJson(const BaseSearch& search, std::vector<BaseTrial> done, bool complete);

/// The trials of a part. Errors, with `name`: as ReadPartJobs, or a trial that cannot be one of this search.
[[nodiscard]] Expected<std::vector<BaseTrial>> ReadBasePart(const BaseSearch& search, std::string_view text,
                                                            const std::string& name);

struct BaseAnswer {                 // NOLINT(bugprone-exception-escape): nlohmann::json checks itself when moved.
  std::vector<BaseTrial> ranked;    ///< Best first.
  std::string explanation;          ///< Why there is no best one; empty when there is.
  Json json;                        ///< The result as docs/manifold.md describes it.
  ExitStatus status = kExitSolved;  ///< kExitInfeasible where there is no best one.
};

/// What finished trials found together: the same bytes whoever ran them.
BaseAnswer AnswerBases(const BaseSearch& search, std::vector<BaseTrial> trials);

}  // namespace tautline

#endif  // APPS_ANSWERS_BASE_SEARCH_H_
