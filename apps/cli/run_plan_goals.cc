// `tautline plan --goals`: one preparation, many goals.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "apps/answers/plan_goals.h"
#include "apps/cli/goals_file.h"
#include "apps/cli/in_order.h"
#include "apps/cli/output_file.h"
#include "apps/cli/plan_command.h"
#include "apps/cli/prepared_options.h"
#include "tautline/planners/tether/prepared_file.h"

namespace tautline::cli {
namespace {

/// A line of the output.
struct GoalLine {
  std::string text;
  int status = kExitSolved;
};

std::optional<Error> PictureOfMany(const CommonOptions& options) {
  if (options.svg.empty() && options.png.empty()) return std::nullopt;
  return Error{ErrorCode::kInvalidInput, "a picture shows one goal, and --goals asks for many; leave one of them out",
               options.svg.empty() ? "--png" : "--svg"};
}

/// Prints a line for each goal: the worst of their statuses, or what could not be written.
Expected<int> PrintLines(const PlanGoals& plans, const std::vector<Point>& goals, int threads, ProgressBar& progress) {
  Expected<int> status = kExitSolved;
  const auto compute = [&](std::size_t i) {
    const GoalAnswer answer = plans.Answer(goals[i]);
    return GoalLine{answer.json.dump() + "\n", answer.status};
  };
  const auto take = [&](std::size_t i, const GoalLine& line) {
    progress.Clear();
    if (const auto written = WriteWholeLine(line.text); !written) {
      status = tl::unexpected(written.error());
      return false;
    }
    progress.Tell("goals", static_cast<double>(i + 1) / static_cast<double>(goals.size()));
    status = std::max(*status, line.status);
    return true;
  };
  progress.Tell("goals", 0);
  InOrder<GoalLine>::Run({.count = goals.size(), .threads = threads}, compute, take);
  return status;
}

}  // namespace

Expected<int> RunPlanGoals(const PlanCommand& command) {
  if (const auto error = PictureOfMany(command.common)) return tl::unexpected(*error);
  const bool standard_input = command.goals == "-";
  const auto scene = ReadScene(command.common, standard_input ? "" : command.goals);
  if (!scene) return tl::unexpected(scene.error());
  const auto goals = ReadGoals(command.goals);
  if (!goals) return tl::unexpected(goals.error());
  ProgressBar progress(!command.common.quiet);
  auto preparation = ReadPreparation(command.common, progress);
  if (!preparation) return tl::unexpected(preparation.error());
  const auto plans = PlanGoals::Prepare(
      *scene, {.options = command.options, .verify = command.common.verify, .preparation = std::move(*preparation)});
  if (!plans) return tl::unexpected(plans.error());
  OutputFiles files;
  if (!command.common.save_prepared.empty()) {
    const std::string bytes = PreparedFile::Write(plans->planner(), scene->world);
    if (auto added = files.Add(command.common.save_prepared, bytes); !added) return tl::unexpected(added.error());
  }
  auto status = PrintLines(*plans, *goals, command.common.threads, progress);
  if (!status) return status;
  if (const auto placed = files.Commit(); !placed) return tl::unexpected(placed.error());
  return status;
}

}  // namespace tautline::cli
