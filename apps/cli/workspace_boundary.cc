// `tautline workspace boundary`: the workspace of the cables as they are laid.
#include <fmt/format.h>

#include <memory>

#include "apps/answers/boundary_answer.h"
#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "apps/cli/workspace_commands.h"
#include "apps/pictures/workspace_pictures.h"
#include "tautline/scene/number_text.h"

namespace tautline::cli {
namespace {

std::string DescribeFutures(const FutureOutcomes& outcomes) {
  std::string text = fmt::format("  expected {}", SquareMetres(outcomes.expected_area));
  if (outcomes.lost_probability > 0) text += fmt::format(", lost with {:.4g} %", 100 * outcomes.lost_probability);
  text += "\n";
  for (const FutureOutcome& outcome : outcomes.outcomes) {
    text += fmt::format("  {:>8.4g} %  {}\n", 100 * outcome.probability,
                        outcome.boundary ? SquareMetres(outcome.boundary->area)
                                         : "no workspace: " + outcome.boundary.error().explanation);
  }
  for (std::size_t i = 0; i < outcomes.longest_cables.size(); ++i) {
    text += fmt::format("  winch {} needs {} over all futures\n", i + 1, Metres(outcomes.longest_cables[i]));
  }
  return text;
}

std::string ToText(const BoundaryAnswer& answer) {
  if (!answer.boundary) return fmt::format("No workspace: {}.\n", answer.boundary.error().explanation);
  const std::vector<std::string> names = NamesOf(answer.setup.ground.space().free_space());
  const WorkspaceBoundary& boundary = *answer.boundary;
  const std::size_t n = boundary.sides.size();
  std::string text =
      fmt::format("Workspace: {} within a boundary of {}.\n", SquareMetres(boundary.area), Metres(boundary.length));
  for (std::size_t i = 0; i < n; ++i) {
    const TautPath& path = boundary.sides[i].path;
    text += fmt::format("  {:>8}  {:>13}  {}\n", fmt::format("{} to {}", i + 1, NextAnchor(i, n) + 1),
                        Metres(path.length), Describe(path.word, names));
  }
  for (std::size_t i = 0; i < n; ++i) {
    text += fmt::format("  winch {} needs {} of cable, when the robot is at winch {}\n", i + 1,
                        Metres(answer.longest[i].length), answer.longest[i].farthest + 1);
  }
  if (answer.outcomes) text += DescribeFutures(*answer.outcomes);
  return text + DescribeVerification(answer.verified_curves);
}

Expected<int> RunBoundary(const CommonOptions& options) {
  const auto scene = ReadScene(options);
  if (!scene) return tl::unexpected(scene.error());
  const auto answer = AnswerBoundary(*scene, {.verify = options.verify});
  if (!answer) return tl::unexpected(answer.error());
  const auto draw = [&] { return DrawAnswer(*scene, *answer); };
  return Deliver(options, {.json = answer->json, .text = ToText(*answer), .draw = draw, .status = answer->status});
}

}  // namespace

Run AddWorkspaceBoundary(CLI::App& workspace) {
  const auto options = std::make_shared<CommonOptions>();
  CLI::App* sub = workspace.add_subcommand("boundary", "where the cables as laid let the robot go");
  AddCommonOptions(*sub, *options);
  sub->footer(
      "Example:\n  tautline workspace boundary scenes/workspace.yaml --svg workspace.svg\n"
      "Exit status: 0 solved, 2 bad input, 3 the cables bound no workspace.");
  return [options] { return RunBoundary(*options); };
}

}  // namespace tautline::cli
