// `tautline fleet check`: whether a layout of cables can be made at all.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "apps/answers/check_answer.h"
#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "apps/cli/fleet_commands.h"
#include "apps/cli/progress_bar.h"
#include "apps/pictures/fleet_pictures.h"
#include "tautline/scene/number_text.h"

namespace tautline::cli {
namespace {

/// Faults listed in the text; JSON has all.
constexpr std::size_t kMostListed = 30;

std::string ToText(const CheckAnswer& answer) {
  if (answer.status == kExitSolved) {
    return fmt::format("The layout is free of crossings: {}, {} of cable.\n",
                       Counted(answer.setup.ground.size(), "robot", "robots"),
                       Metres(answer.json["length"].get<double>()));
  }
  const auto& explanations = answer.explanations;
  std::string text =
      fmt::format("The layout cannot be made, for {}:\n", Counted(explanations.size(), "reason", "reasons"));
  for (std::size_t i = 0; i < std::min(explanations.size(), kMostListed); ++i) {
    text += fmt::format("  {}\n", explanations[i]);
  }
  if (explanations.size() > kMostListed) text += fmt::format("  ... and {} more\n", explanations.size() - kMostListed);
  return text;
}

Expected<int> RunCheck(const CommonOptions& common) {
  const auto scene = ReadScene(common);
  if (!scene) return tl::unexpected(scene.error());
  ProgressBar progress(!common.quiet);
  const auto answer = AnswerCheck(*scene, progress.watcher());
  progress.Clear();
  if (!answer) return tl::unexpected(answer.error());
  const auto draw = [&] { return DrawAnswer(*scene, *answer); };
  return Deliver(common, {.json = answer->json, .text = ToText(*answer), .draw = draw, .status = answer->status});
}

}  // namespace

Run AddFleetCheck(CLI::App& fleet) {
  const auto common = std::make_shared<CommonOptions>();
  CLI::App* sub = fleet.add_subcommand("check", "whether the layout of the cable lines is free of crossings");
  AddCommonOptions(*sub, *common);
  sub->footer(
      "Example:\n  tautline fleet check scenes/fleet.yaml --svg layout.svg\n"
      "Exit status: 0 nothing is wrong, 2 bad input, 3 cable lines cross, loop, enclose a start or are none.");
  return [common] { return RunCheck(*common); };
}

}  // namespace tautline::cli
