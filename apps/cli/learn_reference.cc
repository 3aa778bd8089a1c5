// `tautline learn reference`: the path that a contact-free planner keeps near.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "apps/answers/reference_answer.h"
#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "apps/cli/learn_commands.h"
#include "apps/cli/option_checks.h"
#include "apps/cli/progress_bar.h"
#include "apps/pictures/reference_pictures.h"
#include "tautline/scene/number_text.h"

namespace tautline::cli {
namespace {

/// Classes listed in the text; JSON has all.
constexpr std::size_t kMostListed = 20;

struct ReferenceCommand {
  CommonOptions common;
  ReferenceQuestion question;
};

std::string DescribeCandidate(const ReferenceCandidate& candidate, bool chosen, const std::vector<std::string>& names) {
  const std::string tether = !candidate.tether ? "tether unknown"
                             : candidate.fits  ? "tether " + Metres(candidate.tether->length)
                                               : "tether " + Metres(candidate.tether->length) + ", too long";
  return fmt::format("  {} {:>12}  {:<30}  {}\n", chosen ? '*' : ' ', Metres(candidate.path.length), tether,
                     Describe(candidate.path.word, names));
}

std::string DescribeSelection(const std::string& way, const ReferenceSelection& selection,
                              const std::vector<std::string>& names) {
  std::string text = way + ": ";
  if (const auto& reference = selection.reference) {
    text += fmt::format("reference of {}, class {}, tether {}", Metres(reference->length_m),
                        Describe(reference->word, names), Metres(reference->tether_length_m));
  } else {
    text += "no reference: " + selection.explanation;
  }
  text += "\n";
  const std::size_t listed = std::min(selection.candidates.size(), kMostListed);
  for (std::size_t i = 0; i < listed; ++i) {
    const ReferenceCandidate& candidate = selection.candidates[i];
    const bool chosen = selection.reference && candidate.path.points == selection.reference->path;
    text += DescribeCandidate(candidate, chosen, names);
  }
  if (selection.candidates.size() > listed) {
    text += fmt::format("  ... and {} more\n", selection.candidates.size() - listed);
  }
  return text;
}

std::string DescribeTracked(const TrackedPath& tracked) {
  if (!tracked.path) return fmt::format("  {:<10} no path in this class\n", tracked.method);
  const TrackResult& track = tracked.track;
  return fmt::format(
      "  {:<10} {:>12}  driven {:>12} in {:>7}  contacts a minute: cable-obstacle {:.2f}, cable-robot {:.2f}{}\n",
      tracked.method, Metres(Length(*tracked.path)), Metres(track.driven_m), ShortNumber(track.time_s) + " s",
      track.PerMinute(track.cable_obstacle_steps), track.PerMinute(track.cable_robot_steps),
      track.success() ? "" : std::string("  failed: ") + ToString(track.end));
}

std::string ToText(const ReferenceAnswer& answer) {
  const std::vector<std::string> names = NamesOf(answer.ground.space().free_space());
  std::string text = DescribeSelection("Exact", answer.exact, names);
  if (answer.yen) text += DescribeSelection("Yen's paths", *answer.yen, names);
  if (!answer.tracked.empty()) text += "Tracked:\n";
  for (const TrackedPath& tracked : answer.tracked) text += DescribeTracked(tracked);
  return text + DescribeVerification(answer.verified_curves);
}

std::string DescribeTimes(const ReferenceAnswer& answer) {
  std::string text = fmt::format("Ground {:.1f} ms, exact {:.2f} ms", answer.times.ground, answer.times.exact);
  if (answer.yen) text += fmt::format(", Yen's paths {:.1f} ms", answer.times.yen);
  return text + ".\n";
}

Expected<int> RunReference(const ReferenceCommand& command) {
  const auto scene = ReadScene(command.common);
  if (!scene) return tl::unexpected(scene.error());
  ReferenceQuestion question = command.question;
  question.verify = command.common.verify;
  ProgressBar progress(!command.common.quiet);
  question.watch = progress.watcher();
  const auto answer = AnswerReference(*scene, question);
  progress.Clear();
  if (!answer) return tl::unexpected(answer.error());
  const std::string text = ToText(*answer) + (question.time ? DescribeTimes(*answer) : "");
  const auto draw = [&] { return DrawAnswer(*scene, *answer); };
  return Deliver(command.common, {.json = answer->json, .text = text, .draw = draw, .status = answer->status});
}

}  // namespace

Run AddLearnReference(CLI::App& learn) {
  const auto command = std::make_shared<ReferenceCommand>();
  CLI::App* sub = learn.add_subcommand("reference", "the shortest path to the goal whose class the cable allows");
  AddCommonOptions(*sub, command->common);
  ReferenceQuestion& question = command->question;
  sub->add_option("--robot-radius", question.robot_radius_m, "of the robot's disc; default: the scene's, else 0.5")
      ->type_name("METRES")
      ->check(Positive());
  sub->add_option("--count", question.count, "how many of the shortest classes to list")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub->add_flag("--yen", question.yen, "also as the paper finds it: by the shortest paths of a lattice");
  sub->add_option("--paths", question.paths, "with --yen: how many paths each way")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub->add_option("--step", question.step_m, "the side of a lattice cell; default: the robot's radius")
      ->type_name("METRES")
      ->check(Positive());
  sub->add_flag("--baselines", question.baselines,
                "also the shortest paths of the class on a lattice and on the Voronoi diagram, and all of them driven");
  sub->add_option("--lookahead", question.lookahead_m, "with --baselines: how far ahead the robot steers")
      ->type_name("METRES")
      ->check(Positive())
      ->capture_default_str();
  sub->add_option("--budget", question.budget, "search steps after which to stop")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub->add_flag("--time", question.time, "also say how long each way took");
  sub->footer(
      "Example:\n  tautline learn reference scenes/store_room.yaml --robot-radius 0.3 --yen --svg reference.svg\n"
      "Exit status: 0 solved, 2 bad input, 3 no class has a tether that fits, or the budget ran out.");
  return [command] { return RunReference(*command); };
}

}  // namespace tautline::cli
