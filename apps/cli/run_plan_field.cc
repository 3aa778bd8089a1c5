// `tautline plan --field`: the best next heading from everywhere.
#include <fmt/format.h>

#include <set>
#include <utility>

#include "apps/answers/plan_field_answer.h"
#include "apps/cli/describe.h"
#include "apps/cli/in_order.h"
#include "apps/cli/plan_command.h"
#include "apps/cli/prepared_options.h"
#include "tautline/draw/draw_field.h"
#include "tautline/planners/tether/prepared_file.h"
#include "tautline/scene/number_text.h"

namespace tautline::cli {
namespace {

std::string ToText(const PlanFieldAnswer& answer, Point goal) {
  if (answer.from_base.status == PlanStatus::kInfeasible) {
    return fmt::format("No motion from anywhere: {}.\n", answer.from_base.explanation);
  }
  std::set<std::pair<int, int>> points;
  double farthest = 0;
  for (const FieldSample& sample : answer.samples) {
    points.emplace(sample.row, sample.column);
    farthest = std::max(farthest, sample.length);
  }
  std::string text = fmt::format("A field of {} x {} points, {} apart, to the goal {}.\n", answer.grid.columns,
                                 answer.grid.rows, Metres(answer.grid.resolution), Describe({&goal, 1}));
  text += fmt::format("  reached  {} of {}, {} with headings\n", Counted(points.size(), "point", "points"),
                      static_cast<std::int64_t>(answer.grid.columns) * answer.grid.rows,
                      Counted(answer.samples.size(), "sample", "samples"));
  text += fmt::format("  farthest {} to the goal\n", Metres(farthest));
  if (!answer.complete) text += "  stopped  the search from some points stopped at its budget; they are missing\n";
  return text + DescribeVerification(answer.verified_curves);
}

/// Runs the rows in threads, and tells how far they are.
RowRunner RowsIn(int threads, ProgressBar& progress) {
  return [threads, &progress](int rows, const std::function<CheckedRow(int row)>& compute) {
    std::vector<CheckedRow> all;
    progress.Tell("field", 0);
    const auto take = [&](std::size_t i, CheckedRow row) {
      all.push_back(std::move(row));
      progress.Tell("field", static_cast<double>(i + 1) / rows);
      return true;
    };
    InOrder<CheckedRow>::Run(
        {.count = static_cast<std::size_t>(rows), .threads = threads},
        [&](std::size_t row) { return compute(static_cast<int>(row)); }, take);
    return all;
  };
}

}  // namespace

Expected<int> RunPlanField(const PlanCommand& command) {
  const auto scene = ReadScene(command.common);
  if (!scene) return tl::unexpected(scene.error());
  ProgressBar progress(!command.common.quiet);
  auto preparation = ReadPreparation(command.common, progress);
  if (!preparation) return tl::unexpected(preparation.error());
  const auto answer = AnswerPlanField(*scene, {.options = {.resolution = command.resolution,
                                                           .classes = command.field_classes,
                                                           .budget = command.options.budget},
                                               .verify = command.common.verify,
                                               .preparation = std::move(*preparation),
                                               .run_rows = RowsIn(command.common.threads, progress)});
  progress.Clear();
  if (!answer) return tl::unexpected(answer.error());
  const auto draw = [&] {
    return DrawField(*scene, answer->planner->space().free_space(),
                     {.from_base = answer->from_base, .grid = answer->grid, .samples = answer->samples});
  };
  const auto prepared = [&] { return PreparedFile::Write(*answer->planner, scene->world); };
  return Deliver(command.common, {.json = answer->json,
                                  .text = ToText(*answer, *scene->goal),
                                  .draw = draw,
                                  .prepared = prepared,
                                  .status = answer->status});
}

}  // namespace tautline::cli
