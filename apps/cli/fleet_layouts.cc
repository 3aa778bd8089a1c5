// `tautline fleet layouts`: all layouts that a fleet can make, the shortest first.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "apps/answers/layouts_answer.h"
#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "apps/cli/fleet_commands.h"
#include "apps/cli/option_checks.h"
#include "apps/cli/progress_bar.h"
#include "apps/pictures/fleet_pictures.h"
#include "tautline/scene/number_text.h"

namespace tautline::cli {
namespace {

/// Layouts listed in the text; JSON has all.
constexpr std::size_t kMostListed = 10;

struct LayoutsCommand {
  CommonOptions common;
  LayoutsQuestion question;
};

void AddBend(const std::string& bend, std::string& text) { text += (text.empty() ? " around " : ", ") + bend; }

/// " straight", or " around r2, 2 corners, r3": where a cable bends.
std::string DescribeBends(const FleetGround& ground, const Route& route) {
  const Route bends = BendsOf(ground, route);
  if (bends.size() == 2) return " straight";
  std::string text;
  std::size_t corners = 0;
  for (std::size_t k = 1; k < bends.size(); ++k) {
    const RobotId at = ground.robot_at(bends[k].node);
    if (!at.valid()) ++corners;
    if (at.valid() && corners > 0) AddBend(Counted(corners, "corner", "corners"), text);
    if (at.valid()) corners = 0;
    if (at.valid() && k + 1 < bends.size()) AddBend(ground.robot(at).name, text);
  }
  return text;
}

std::string DescribeCables(const FleetGround& ground, const FoundLayout& layout) {
  std::string text;
  for (std::size_t i = 0; i < layout.routes.size(); ++i) {
    text += (i > 0 ? "; " : "") + ground.robots()[i].name + DescribeBends(ground, layout.routes[i]);
  }
  return text;
}

std::string ToText(const LayoutsAnswer& answer) {
  const LayoutsResult& result = answer.result;
  if (!answer.explanation.empty()) return fmt::format("No layout: {}.\n", answer.explanation);
  std::string text = Counted(result.layouts.size(), "layout", "layouts");
  if (result.count) text += fmt::format(" of {} in all", *result.count);
  if (result.budget_exceeded) {
    text += ", more may exist: the budget ran out; none below " + Metres(result.complete_below) + " is missing";
  } else if (!result.complete) {
    text += ", longer ones exist";
  }
  text += ":\n";
  for (std::size_t i = 0; i < std::min(result.layouts.size(), kMostListed); ++i) {
    const FoundLayout& layout = result.layouts[i];
    text +=
        fmt::format("  {:3}  {:>12}  {}\n", i + 1, Metres(layout.total), DescribeCables(answer.setup.ground, layout));
  }
  if (result.layouts.size() > kMostListed)
    text += fmt::format("  ... and {} more\n", result.layouts.size() - kMostListed);
  return text + DescribeVerification(answer.verified_curves);
}

Expected<int> RunLayouts(const LayoutsCommand& command) {
  const auto scene = ReadScene(command.common);
  if (!scene) return tl::unexpected(scene.error());
  LayoutsQuestion question = command.question;
  question.verify = command.common.verify;
  ProgressBar progress(!command.common.quiet);
  question.options.watch = progress.watcher();
  const auto answer = AnswerLayouts(*scene, question);
  progress.Clear();
  if (!answer) return tl::unexpected(answer.error());
  const auto draw = [&] { return DrawAnswer(*scene, *answer); };
  return Deliver(command.common,
                 {.json = answer->json, .text = ToText(*answer), .draw = draw, .status = answer->status});
}

}  // namespace

Run AddFleetLayouts(CLI::App& fleet) {
  const auto command = std::make_shared<LayoutsCommand>();
  CLI::App* sub = fleet.add_subcommand("layouts", "all layouts without crossings for these starts and targets");
  AddCommonOptions(*sub, command->common);
  LayoutsOptions& options = command->question.options;
  sub->add_option("--max-length", options.max_length, "only cable lines no longer than this")
      ->type_name("METRES")
      ->check(NonNegative());
  sub->add_option("--max-total", options.max_total, "only layouts whose cable lines are together no longer than this")
      ->type_name("METRES")
      ->check(NonNegative());
  sub->add_option("--count", options.max_count, "only so many, the shortest")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub->add_flag("--count-all", options.count_all, "also count all layouts up to the limits");
  sub->add_option("--budget", options.budget, "search steps after which to stop")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub->footer(
      "Example:\n  tautline fleet layouts scenes/fleet.yaml --count 6 --svg layouts.svg\n"
      "Exit status: 0 solved, 2 bad input, 3 there is no layout, or the budget ran out.");
  return [command] { return RunLayouts(*command); };
}

}  // namespace tautline::cli
