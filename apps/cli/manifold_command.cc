// `tautline manifold`: the configuration space of the tethered robot on a grid.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "apps/answers/deadlock_json.h"
#include "apps/answers/manifold_answer.h"
#include "apps/cli/best_base.h"
#include "apps/cli/commands.h"
#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "apps/cli/option_checks.h"
#include "apps/cli/parallel_ranges.h"
#include "apps/cli/prepared_options.h"
#include "apps/pictures/manifold_pictures.h"
#include "tautline/planners/grid_manifold/manifold_file.h"
#include "tautline/scene/number_text.h"
#include "tautline/scene/world_digest.h"

namespace tautline::cli {
namespace {

/// Sheets listed in the text; JSON has all.
constexpr std::size_t kMostListed = 8;

struct ManifoldCommand {
  CommonOptions common;
  ManifoldQuestion question;
  BestBaseOptions best_base;
  double resolution = 0;
  int connectivity = 0;
};

std::string DescribeSheets(const ManifoldAnswer& answer) {
  const std::vector<std::string>& names = answer.manifold->ground().names();
  std::string text = fmt::format("  sheets   {}\n", Counted(answer.sheets.size(), "word", "words"));
  for (std::size_t i = 0; i < std::min(kMostListed, answer.sheets.size()); ++i) {
    text += fmt::format("  {:3}  {:>9} vertices  {}\n", i + 1, answer.sheets[i].vertices,
                        Describe(answer.sheets[i].word, names));
  }
  if (answer.sheets.size() > kMostListed) {
    text += fmt::format("  ... and {} smaller ones\n", answer.sheets.size() - kMostListed);
  }
  return text;
}

std::string DescribeDeadlocks(const World& world, const ManifoldAnswer& answer) {
  std::string text = fmt::format("  closed   {} over all classes, {} of ground in every class\n",
                                 SquareMetres(answer.json.at("deadlock_area").get<double>()),
                                 SquareMetres(answer.json.at("lost_area").get<double>()));
  const std::vector<DeadlockCause> causes = CausesOf(world, *answer.manifold, *answer.deadlocks);
  if (causes.empty()) return text + "  deadlock none: every contact can be resolved\n";
  const double cell_m = answer.manifold->ground().cell_m();
  for (std::size_t i = 0; i < std::min(kMostListed, causes.size()); ++i) {
    text += fmt::format("  {:>9}  by {}: {}\n", SquareMetres(static_cast<double>(causes[i].closed) * cell_m * cell_m),
                        causes[i].obstacle, Counted(causes[i].deadlocks, "deadlock", "deadlocks"));
  }
  if (causes.size() > kMostListed) text += fmt::format("  ... and {} others\n", causes.size() - kMostListed);
  return text;
}

std::string ToText(const World& world, const ManifoldAnswer& answer) {
  if (answer.json.at("status") == "infeasible") return fmt::format("No manifold: {}.\n", answer.explanation);
  const ManifoldCounts& counts = answer.counts;
  std::int64_t cells = 0;
  for (const std::int64_t count : counts.multiplicity) cells += count;
  std::string text = fmt::format("A manifold of {} vertices and {} edges over {} of {} free cells of {}.\n",
                                 counts.vertices, counts.edges, cells, answer.json.at("free_cells").get<std::int64_t>(),
                                 Metres(answer.json.at("resolution").get<double>()));
  if (cells > 0) {
    text += fmt::format("  a cell   carries up to {} vertices, {:.4g} on average\n", counts.multiplicity.size(),
                        static_cast<double>(counts.vertices) / static_cast<double>(cells));
  }
  text += fmt::format("  farthest {} from the base\n", Metres(answer.json.at("max_distance").get<double>()));
  if (answer.manifold && !answer.sheets.empty()) text += DescribeSheets(answer);
  if (answer.json.contains("field")) {
    const Json& field = answer.json.at("field");
    text += fmt::format("  goal     {}", Counted(field.at("goal_vertices").get<std::size_t>(), "vertex", "vertices"));
    if (field.contains("from_base")) {
      text += fmt::format(", {} from the base", Metres(field.at("from_base").get<double>()));
    }
    text += "\n";
  }
  if (answer.deadlocks) text += DescribeDeadlocks(world, answer);
  if (!answer.explanation.empty()) text += fmt::format("  stopped  {}.\n", answer.explanation);
  return text;
}

/// Where the base is sought, it is no question of one manifold.
Expected<int> RunBestBase(const ManifoldCommand& command) {
  const ManifoldQuestion& question = command.question;
  if (question.literal || question.sheets || question.field || question.deadlocks || !command.common.prepared.empty() ||
      !command.common.save_prepared.empty()) {
    return InvalidInput("the search for a base answers nothing else: leave out the other options", "--best-base");
  }
  BaseQuestion base{.max_vertices = question.max_vertices, .max_bytes = question.max_bytes};
  if (command.resolution > 0) base.cells.resolution_m = command.resolution;
  if (command.connectivity > 0) base.connectivity = command.connectivity;
  base.cells.unknown_free = command.common.unknown == "free";
  return RunBestBase(command.common, command.best_base, base);
}

Expected<int> RunManifold(ManifoldCommand& command) {
  if (command.best_base.asked) return RunBestBase(command);
  const auto scene = ReadScene(command.common);
  if (!scene) return tl::unexpected(scene.error());
  ProgressBar progress(!command.common.quiet);
  auto preparation = ReadPreparation(command.common, progress);
  if (!preparation) return tl::unexpected(preparation.error());
  ManifoldQuestion question = command.question;
  if (command.resolution > 0) question.cells.resolution_m = command.resolution;
  if (command.connectivity > 0) question.connectivity = command.connectivity;
  if (question.literal && !command.common.save_prepared.empty()) {
    return InvalidInput("the printed construction is not kept: leave out --save-prepared", "--literal");
  }
  question.cells.unknown_free = command.common.unknown == "free";
  question.prepared = std::move(preparation->prepared);
  question.prepared_path = preparation->path;
  question.watch = progress.watcher();
  RangeThreads threads(command.common.threads);
  if (command.common.threads > 1) {
    question.parallel = [&threads](std::size_t count, const RangeThreads::Work& work) { threads.Run(count, work); };
  }
  const auto answer = AnswerManifold(*scene, question);
  progress.Clear();
  if (!answer) return tl::unexpected(answer.error());
  const auto draw = [&] { return DrawAnswer(*scene, *answer); };
  const auto prepared = [&] {
    return answer->manifold ? ManifoldFile::Write(*answer->manifold, WorldDigest(scene->world)) : std::string();
  };
  return Deliver(command.common, {.json = answer->json,
                                  .text = ToText(scene->world, *answer),
                                  .draw = draw,
                                  .prepared = prepared,
                                  .status = answer->status});
}

}  // namespace

Run AddManifold(CLI::App& app) {
  const auto command = std::make_shared<ManifoldCommand>();
  CLI::App* sub = app.add_subcommand("manifold", "every place and class of the tethered robot, on a grid");
  AddCommonOptions(*sub, command->common);
  AddPreparedOptions(*sub, command->common);
  sub->add_option("--resolution", command->resolution, "the side of a cell; default: that of the map's own cells")
      ->type_name("METRES")
      ->check(Positive());
  sub->add_option("--connectivity", command->connectivity, "steps to 4 or 8 cells; default 8, with --literal 4")
      ->check(FourOrEight());
  sub->add_flag("--literal", command->question.literal, "the construction as it is printed, for comparison");
  sub->add_flag("--sheets", command->question.sheets, "also word by word, with boundaries");
  sub->add_flag("--field", command->question.field, "also the distance and the next heading to the goal");
  sub->add_flag("--deadlocks", command->question.deadlocks, "also where the tether can lock the robot in");
  AddBestBaseOptions(*sub, command->best_base);
  sub->add_option("--max-nodes", command->question.max_vertices, "vertices after which to stop")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub->add_option("--max-bytes", command->question.max_bytes, "bytes of memory after which to stop")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub->footer(
      "Example:\n  tautline manifold scenes/two_ways.yaml --resolution 0.25 --svg manifold.svg\n"
      "Exit status: 0 solved, 2 bad input, 3 the base is blocked, or a budget ran out.");
  return [command] { return RunManifold(*command); };
}

}  // namespace tautline::cli
