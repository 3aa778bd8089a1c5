#include "tautline/planners/cable_workspace/place.h"

#include <algorithm>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

std::string TaskName(const PlacementGround& ground, std::size_t task) {
  return "task " + std::to_string(task + 1) + " " + ToText(ground.options().tasks[task]);
}

/// Where no placement can hold all tasks.
void ExplainLostTask(const PlacementGround& ground, std::size_t task, PlaceResult& result) {
  const bool blocked = !ground.ground().space().Locate(ground.options().tasks[task]);
  result.status = PlaceStatus::kInfeasible;
  result.obstruction = WorkspaceObstruction::kTaskOutside;
  result.explanation = TaskName(ground, task) +
                       (blocked ? " lies inside an obstacle or a wall, or within its clearance"
                                : " is cut off from " + TaskName(ground, 0)) +
                       ": no workspace can hold it";
}

/// What may have kept a search from finding any.
std::string Advice(const PlaceResult& result) {
  if (result.incomplete == 0) return "; more jobs or evaluations may find one";
  return "; in " + std::to_string(result.incomplete) +
         " of them the budget ended before all boundaries were known: raise it, or lower the limit";
}

/// Where none was found.
void ExplainNothing(const PlacementGround& ground, PlaceResult& result) {
  result.status = PlaceStatus::kBudgetExceeded;
  result.obstruction = WorkspaceObstruction::kNoBoundary;
  const std::string limit = "of up to " + Metres(ground.max_boundary());
  const std::string tried = " at the " + std::to_string(result.evaluations) + " placements that were looked at";
  if (!result.placement) {
    result.explanation = "no valid boundary " + limit + " was found" + tried + Advice(result);
    return;
  }
  result.explanation = "no boundary " + limit + " that holds all tasks was found" + tried + "; the best one holds " +
                       std::to_string(result.details.tasks_held) + " of " +
                       std::to_string(ground.options().tasks.size()) + Advice(result);
}

/// What the best of a job was compared with when it was found.
std::optional<PlacementWorth> BeatenBy(const PlaceJob& job) {
  if (job.gains.size() < 2) return std::nullopt;
  return job.gains[job.gains.size() - 2].worth;
}

}  // namespace

Expected<PlaceResult> JoinPlaceJobs(const PlacementGround& ground, std::vector<PlaceJob> jobs) {
  std::sort(jobs.begin(), jobs.end(), [](const PlaceJob& a, const PlaceJob& b) { return a.job < b.job; });
  PlaceResult result;
  result.jobs = jobs.size();
  std::optional<PlacementWorth> best;
  const PlaceJob* best_job = nullptr;
  for (const PlaceJob& job : jobs) {
    for (const PlaceGain& gain : job.gains) {
      if (best && !ground.IsBetter(gain.worth, *best)) continue;
      best = gain.worth;
      best_job = &job;
      if (!gain.worth.holds_all()) continue;
      result.history.push_back({job.job, result.evaluations + gain.evaluation, gain.worth.value});
    }
    result.starts.push_back(job.start);
    result.evaluations += job.evaluations;
    result.incomplete += job.incomplete;
  }
  if (best_job != nullptr) {
    result.placement = ground.Evaluate(best_job->positions, BeatenBy(*best_job)).placement;
    if (!result.placement || result.placement->worth != *best) {
      return InvalidInput("job " + std::to_string(best_job->job) + " found a placement worth " +
                          ShortNumber(best->value) + " that is worth " +
                          (result.placement ? ShortNumber(result.placement->worth.value) : "nothing") +
                          " here: run it again with this version of tautline");
    }
    result.details = ground.DetailsOf(*result.placement);
  }
  if (best && best->holds_all()) {
    result.status = PlaceStatus::kSolved;
  } else if (const auto lost = ground.lost_task()) {
    ExplainLostTask(ground, *lost, result);
  } else {
    ExplainNothing(ground, result);
  }
  return result;
}

PlaceResult PlaceWinches(const PlacementGround& ground, const PlaceOptions& options) {
  // Where no placement can hold all tasks, there is nothing to search for.
  const std::size_t count = ground.lost_task() ? 0 : options.jobs;
  std::vector<PlaceJob> jobs;
  for (std::size_t k = 0; k < count; ++k) {
    if (options.watch && !options.watch("places", static_cast<double>(k) / static_cast<double>(count))) break;
    auto job = RunPlaceJob(ground, options.job, k);
    if (!job) break;
    jobs.push_back(*std::move(job));
  }
  auto joined = JoinPlaceJobs(ground, std::move(jobs));
  TAUTLINE_CHECK(joined.has_value());
  return *std::move(joined);
}

}  // namespace tautline
