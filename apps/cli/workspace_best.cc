// `tautline workspace best`: the best ways to lay the cables.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "apps/answers/best_answer.h"
#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "apps/cli/option_checks.h"
#include "apps/cli/progress_bar.h"
#include "apps/cli/workspace_commands.h"
#include "apps/pictures/workspace_pictures.h"
#include "tautline/scene/number_text.h"

namespace tautline::cli {
namespace {

/// Boundaries listed in the text; JSON has all.
constexpr std::size_t kMostListed = 12;

struct BestCommand {
  CommonOptions common;
  BestQuestion question;
};

std::string DescribeRanked(std::size_t rank, const RankedBoundary& ranked, const std::vector<std::string>& names) {
  std::string text = fmt::format("  {:3}  {:>15}", rank, SquareMetres(ranked.boundary.area));
  if (ranked.futures) {
    text += fmt::format("  expected {:>15}", SquareMetres(ranked.futures->expected_area));
    const double lost = ranked.futures->lost_probability;
    if (lost > 0) text += fmt::format(" (lost with {:.4g} %)", 100 * lost);
  }
  text += fmt::format("  boundary {:>13} ", Metres(ranked.boundary.length));
  for (const BoundarySide& side : ranked.boundary.sides) text += " '" + tautline::ToString(side.path.word, names) + "'";
  return text + "\n";
}

std::string ToText(const BestAnswer& answer) {
  if (answer.ranked.empty()) return fmt::format("No workspace: {}.\n", answer.explanation);
  const std::vector<std::string> names = NamesOf(answer.setup.ground.space().free_space());
  std::string text = fmt::format("{}{} within {}, the largest {}area first.\n", answer.complete ? "" : "At least ",
                                 Counted(answer.found, "workspace", "workspaces"), Metres(answer.max_boundary),
                                 answer.futures ? "expected " : "");
  const std::size_t listed = std::min(kMostListed, answer.ranked.size());
  for (std::size_t i = 0; i < listed; ++i) text += DescribeRanked(i + 1, answer.ranked[i], names);
  if (listed < answer.found) text += fmt::format("  ... and {} smaller ones\n", answer.found - listed);
  if (answer.json.contains("longer")) {
    text += fmt::format("  longer   {} more up to {}\n", answer.json["longer"]["count"].get<std::int64_t>(),
                        Metres(answer.json["longer"]["up_to"].get<double>()));
  }
  if (!answer.complete) text += fmt::format("  stopped  {}.\n", answer.explanation);
  return text + DescribeVerification(answer.verified_curves);
}

Expected<int> RunBest(const BestCommand& command) {
  const auto scene = ReadScene(command.common);
  if (!scene) return tl::unexpected(scene.error());
  ProgressBar progress(!command.common.quiet);
  BestQuestion question = command.question;
  question.verify = command.common.verify;
  question.watch = progress.watcher();
  question.keep_going = progress.Passing("boundaries");
  const auto answer = AnswerBest(*scene, question);
  progress.Clear();
  if (!answer) return tl::unexpected(answer.error());
  return Deliver(command.common, {.json = answer->json,
                                  .text = ToText(*answer),
                                  .draw = [&] { return DrawAnswer(*scene, *answer); },
                                  .status = answer->status});
}

}  // namespace

Run AddWorkspaceBest(CLI::App& workspace) {
  const auto command = std::make_shared<BestCommand>();
  CLI::App* sub = workspace.add_subcommand("best", "the ways to lay the cables, largest workspace first");
  AddCommonOptions(*sub, command->common);
  BestQuestion& question = command->question;
  sub->add_option("--max-boundary", question.max_boundary, "the longest boundary, metres; without it, the scene's")
      ->type_name("METRES")
      ->check(Positive());
  sub->add_option("--count", question.count, "only the so many best")->check(AtLeastOne());
  sub->add_option("--count-longer", question.longer_to, "also count the boundaries that are longer, up to this, metres")
      ->type_name("METRES")
      ->check(Positive());
  sub->add_option("--budget", question.budget, "search steps after which the list ends incomplete")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub->footer(
      "Example:\n  tautline workspace best scenes/workspace.yaml --count 6 --svg best.svg\n"
      "Exit status: 0 solved, 2 bad input, 3 there is none, or the budget ran out.");
  return [command] { return RunBest(*command); };
}

}  // namespace tautline::cli
