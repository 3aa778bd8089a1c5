// `tautline reach`: where the tether lets the robot go.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "apps/answers/reach_answer.h"
#include "apps/cli/commands.h"
#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "apps/cli/option_checks.h"
#include "apps/cli/point_option.h"
#include "apps/cli/prepared_options.h"
#include "tautline/draw/draw_reach.h"
#include "tautline/planners/tether/prepared_file.h"
#include "tautline/scene/number_text.h"

namespace tautline::cli {
namespace {

/// Sheets listed in the text; JSON has all.
constexpr std::size_t kMostListed = 8;

struct ReachCommand {
  CommonOptions common;
  ReachOptions options;
  std::string at;
};

std::string DescribeBoundary(const ReachResult& result) {
  std::size_t pieces = 0, arcs = 0;
  for (const RegionRing& ring : result.regions) {
    pieces += ring.pieces.size();
    for (const RegionPiece& piece : ring.pieces) arcs += piece.is_arc() ? 1 : 0;
  }
  return fmt::format("{}, {}, of which {} where the tether ends", Counted(result.regions.size(), "ring", "rings"),
                     Counted(pieces, "piece", "pieces"), Counted(arcs, "is an arc", "are arcs"));
}

std::string DescribeSheets(const SheetList& list, double area, const std::vector<std::string>& names) {
  std::string text = fmt::format(
      "  sheets   {}{}, {} in all, {:.4g} classes at a point on average\n", list.complete ? "" : "at least ",
      Counted(static_cast<std::size_t>(list.classes), "class", "classes"), SquareMetres(list.area), list.area / area);
  std::vector<const Sheet*> by_area;
  for (const Sheet& sheet : list.sheets) by_area.push_back(&sheet);
  std::stable_sort(by_area.begin(), by_area.end(), [](const Sheet* a, const Sheet* b) { return a->area > b->area; });
  for (std::size_t i = 0; i < std::min(kMostListed, by_area.size()); ++i) {
    text +=
        fmt::format("  {:3}  {:>13}  {}\n", i + 1, SquareMetres(by_area[i]->area), Describe(by_area[i]->word, names));
  }
  if (by_area.size() > kMostListed) text += fmt::format("  ... and {} smaller ones\n", by_area.size() - kMostListed);
  return text;
}

std::string DescribePoint(const ReachPoint& at, double limit, const std::vector<std::string>& names) {
  if (at.obstruction != PlanObstruction::kNone) return fmt::format("  at       no: {}\n", at.explanation);
  std::string text =
      fmt::format("  at       yes: {} needs {} of {}, class {}\n", Describe({&at.point, 1}),
                  Metres(at.least_tether->length), Metres(limit), Describe(at.least_tether->word, names));
  if (!at.classes) return text;
  for (std::size_t i = 0; i < at.classes->classes.size(); ++i) {
    const TautPath& path = at.classes->classes[i];
    text += fmt::format("  {:3}  {:>13}  {}\n", i + 1, Metres(path.length), Describe(path.word, names));
  }
  if (!at.classes->complete) text += "  ... and longer ones\n";
  return text;
}

std::string ToText(const ReachResult& result, const FreeSpace& space) {
  if (result.status == PlanStatus::kInfeasible) return fmt::format("No reach: {}.\n", result.explanation);
  const std::vector<std::string> names = NamesOf(space);
  const double share = result.connected_area > 0 ? 100 * result.area / result.connected_area : 0;
  std::string text =
      fmt::format("A tether of {} reaches {}, {:.4g} % of the {} of ground that are connected.\n", Metres(result.limit),
                  SquareMetres(result.area), share, SquareMetres(result.connected_area));
  text += fmt::format("  boundary {}\n", DescribeBoundary(result));
  if (result.at) text += DescribePoint(*result.at, result.limit, names);
  if (result.sheets && result.area > 0) text += DescribeSheets(*result.sheets, result.area, names);
  if (!result.explanation.empty()) text += fmt::format("  stopped  {}.\n", result.explanation);
  return text;
}

Expected<int> RunReach(const ReachCommand& command) {
  const auto scene = ReadScene(command.common);
  if (!scene) return tl::unexpected(scene.error());
  ReachOptions options = command.options;
  if (!command.at.empty()) {
    const auto at = ParsePoint(command.at, "--at");
    if (!at) return tl::unexpected(at.error());
    options.at = *at;
  }
  ProgressBar progress(!command.common.quiet);
  auto preparation = ReadPreparation(command.common, progress);
  if (!preparation) return tl::unexpected(preparation.error());
  options.watch = progress.watcher();
  const auto answer = AnswerReach(
      *scene, {.options = options, .verify = command.common.verify, .preparation = std::move(*preparation)});
  progress.Clear();
  if (!answer) return tl::unexpected(answer.error());
  const FreeSpace& space = answer->planner.space().free_space();
  const std::string text = ToText(answer->result, space) + DescribeVerification(answer->verified_curves);
  const auto draw = [&] { return DrawReach(*scene, space, answer->result); };
  const auto prepared = [&] { return PreparedFile::Write(answer->planner, scene->world); };
  return Deliver(command.common,
                 {.json = answer->json, .text = text, .draw = draw, .prepared = prepared, .status = answer->status});
}

}  // namespace

Run AddReach(CLI::App& app) {
  const auto command = std::make_shared<ReachCommand>();
  CLI::App* sub = app.add_subcommand("reach", "where the tether lets the robot go");
  AddCommonOptions(*sub, command->common);
  AddPreparedOptions(*sub, command->common);
  sub->add_option("--at", command->at, "also ask whether the robot can go to this point, and what tether it needs")
      ->type_name("X,Y");
  sub->add_flag("--sheets", command->options.sheets, "also class by class");
  sub->add_option("--budget", command->options.budget, "with --sheets, taut walks after which to stop")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub->footer(
      "Example:\n  tautline reach scenes/store_room.yaml --sheets --svg reach.svg\n"
      "Exit status: 0 solved, 2 bad input, 3 the base is blocked, or the budget ran out.");
  return [command] { return RunReach(*command); };
}

}  // namespace tautline::cli
