// Where to put the winches of a cable robot: the future work of [Wang2018, Sec. VII].
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_PLACE_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_PLACE_H_

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tautline/base/error.h"
#include "tautline/planners/cable_workspace/place_job.h"
#include "tautline/planners/cable_workspace/placement.h"

namespace tautline {

/// How the search for places ended.
enum class PlaceStatus {
  kSolved,          ///< A placement holds all tasks; it is the best that was found.
  kInfeasible,      ///< No placement can: proved.
  kBudgetExceeded,  ///< None was found.
};

/// When the best so far improved.
struct PlaceRecord {
  std::size_t job = 0;           ///< The job that found it.
  std::int64_t evaluations = 0;  ///< Of all jobs up to then, in their order.
  double best = 0;               ///< The value, in the unit of the objective.
};

/// What all jobs together found.
struct PlaceResult {
  PlaceStatus status = PlaceStatus::kBudgetExceeded;               ///< How the search ended.
  WorkspaceObstruction obstruction = WorkspaceObstruction::kNone;  ///< Unless solved.
  std::string explanation;                                         ///< Unless solved: one sentence.
  std::optional<Placement> placement;       ///< The best; unless solved, the one nearest to holding all tasks, if any.
  PlacementDetails details;                 ///< Of the placement, if any.
  std::vector<std::vector<double>> starts;  ///< The positions from which the jobs searched, by job.
  std::vector<PlaceRecord> history;         ///< Placements that hold all tasks, each better than the one before.
  std::int64_t evaluations = 0;             ///< Of all jobs.
  std::int64_t incomplete = 0;  ///< How many of them ran out of budget, so that a better boundary may be missed.
  std::size_t jobs = 0;         ///< How many there were.
};

/// Joins jobs, in any order, none twice. The same jobs give the same result, wherever and in whatever order they were
/// run; of equally good placements that of the first job counts. Errors: the best placement is not worth here what its
/// job says, so that the job was run for something else. O(jobs log jobs) and one evaluation.
[[nodiscard]] Expected<PlaceResult> JoinPlaceJobs(const PlacementGround& ground, std::vector<PlaceJob> jobs);

/// How long the search is.
struct PlaceOptions {
  PlaceJobOptions job = {};  ///< Of each job.
  std::size_t jobs = 64;     ///< Independent searches, numbered from 0 on.
  Watcher watch = {};        ///< Told of the share of jobs; at a no, the jobs so far are joined.
};

/// Runs all jobs, one after the other, and joins them. A job depends on its number and not on those before it, so that
/// a caller can run them in threads, processes or on other machines instead. Cost: jobs times evaluations.
PlaceResult PlaceWinches(const PlacementGround& ground, const PlaceOptions& options);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_PLACE_H_
