// `tautline drive`: a tethered robot visits its goals, with a simulated slack cable.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "apps/answers/drive_answer.h"
#include "apps/cli/commands.h"
#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "apps/cli/goals_file.h"
#include "apps/cli/option_checks.h"
#include "apps/cli/progress_bar.h"
#include "apps/pictures/drive_pictures.h"
#include "tautline/scene/number_text.h"

namespace tautline::cli {
namespace {

/// Goals, and candidates, listed in the text; JSON has all.
constexpr std::size_t kMostListed = 20;

struct DriveCommand {
  CommonOptions common;
  DriveQuestion question;
  double resolution = 0;
  std::string goals;
  std::string controller = "extended";
  std::string untangle = "both";
  std::string prevention = "both";
  bool no_prevention = false;
};

std::string ToText(const GoalOutcome& goal, std::size_t number) {
  std::string text = fmt::format("  {:3}  {:<14} ", number, ToText(goal.goal));
  if (goal.failure != DriveFailure::kNone) {
    return text + (goal.failure == DriveFailure::kNotTried ? "not tried\n" : "not visited\n");
  }
  text += fmt::format("after {:>7.1f} s", goal.time_s);
  if (goal.targets > 0) {
    text += fmt::format(", by {}{}", Counted(static_cast<std::size_t>(goal.targets), "target", "targets"),
                        goal.searched ? " that the search found" : "");
  }
  return text + (goal.retreat_kept ? "\n" : ", without a way back\n");
}

std::string ToText(const TargetTrials& trials) {
  std::string text =
      fmt::format("Candidates on the way to {}{}:\n", ToText(trials.goal), trials.open ? ", which is open" : "");
  for (std::size_t i = 0; i < std::min(kMostListed, trials.targets.size()); ++i) {
    const TriedTarget& target = trials.targets[i];
    text +=
        fmt::format("  {:3}  {:<14} score {:>7}, {}{}\n", i + 1,
                    fmt::format("({:.4g}, {:.4g})", target.at.x, target.at.y), fmt::format("{:.4g} m", target.score_m),
                    target.clears    ? "clears the way"
                    : target.touched ? "pulls the cable under the robot"
                                     : fmt::format("leaves {} vertices", target.region.size()),
                    trials.chosen == i ? ", chosen" : "");
  }
  if (trials.targets.size() > kMostListed) {
    text += fmt::format("  ... and {} more\n", trials.targets.size() - kMostListed);
  }
  return text;
}

std::string ToText(const DriveAnswer& answer) {
  if (answer.trace.empty()) return fmt::format("No drive: {}.\n", answer.explanation);
  const auto robot = answer.json.at("cable_robot_contacts").get<std::size_t>();
  std::string text =
      answer.explanation.empty()
          ? fmt::format("{} visited in {:.1f} s, {} driven.\n",
                        answer.goals.size() == 1 ? "The goal was" : fmt::format("All {} goals", answer.goals.size()),
                        answer.time_s, Metres(answer.driven_m))
          : fmt::format("Stopped after {:.1f} s: {}.\n", answer.time_s, answer.explanation);
  text += fmt::format("  the robot drove over its cable {}; obstacles caught it {}\n", Counted(robot, "time", "times"),
                      Counted(answer.contacts.size() - robot, "time", "times"));
  for (std::size_t i = 0; i < std::min(kMostListed, answer.goals.size()); ++i) {
    text += ToText(answer.goals[i], i + 1);
  }
  if (answer.goals.size() > kMostListed) text += fmt::format("  ... and {} more\n", answer.goals.size() - kMostListed);
  return text + (answer.candidates ? ToText(*answer.candidates) : "");
}

Expected<DriveQuestion> QuestionOf(const DriveCommand& command) {
  DriveQuestion question = command.question;
  if (command.resolution > 0) question.cells.resolution_m = command.resolution;
  question.cells.unknown_free = command.common.unknown == "free";
  question.options.controller = command.controller == "basic"     ? DriveController::kBasic
                                : command.controller == "retract" ? DriveController::kRetract
                                                                  : DriveController::kExtended;
  question.options.untangle = command.untangle == "heuristic" ? Untangling::kHeuristic
                              : command.untangle == "search"  ? Untangling::kSearch
                                                              : Untangling::kBoth;
  const std::string prevention = command.no_prevention ? "none" : command.prevention;
  question.prevent_deadlocks = prevention == "areas" || prevention == "both";
  question.options.lookahead = prevention == "lookahead" || prevention == "both";
  if (command.goals.empty()) return question;
  auto goals = ReadGoals(command.goals);
  if (!goals) return tl::unexpected(goals.error());
  question.goals = *std::move(goals);
  return question;
}

Expected<int> RunDrive(const DriveCommand& command) {
  const auto scene = ReadScene(command.common, command.goals == "-" ? "" : command.goals);
  if (!scene) return tl::unexpected(scene.error());
  auto question = QuestionOf(command);
  if (!question) return tl::unexpected(question.error());
  ProgressBar progress(!command.common.quiet);
  question->watch = progress.watcher();
  question->options.robot.keep_going = progress.Passing("drive");
  const auto answer = AnswerDrive(*scene, *question);
  progress.Clear();
  if (!answer) return tl::unexpected(answer.error());
  return Deliver(command.common, {.json = answer->json,
                                  .text = ToText(*answer),
                                  .draw = [&] { return DrawAnswer(*scene, *question, *answer); },
                                  .animate = [&] { return AnimateAnswer(*scene, *question, *answer); },
                                  .status = answer->status});
}

void AddRobotOptions(CLI::App& sub, DriveCommand& command) {
  RobotOptions& robot = command.question.options.robot;
  sub.add_option("--speed", robot.speed_mps, "of the robot, metres per second")
      ->check(Positive())
      ->capture_default_str();
  sub.add_option("--robot-radius", robot.radius_m, "of the disc that keeps off the cable, metres")
      ->check(NonNegative())
      ->capture_default_str();
  sub.add_option("--link", command.question.options.link_m, "the length of the cable's links, metres")
      ->check(Positive())
      ->capture_default_str();
  sub.add_option("--dt", robot.dt_s, "a step of the simulation, seconds")->check(Positive())->capture_default_str();
  sub.add_option("--time-limit", robot.time_limit_s, "simulated seconds after which the drive ends")
      ->check(Positive())
      ->capture_default_str();
  sub.add_option("--sample", command.question.sample_s, "between the samples of the trace, seconds")
      ->check(Positive())
      ->capture_default_str();
}

void AddWayOptions(CLI::App& sub, DriveCommand& command) {
  DriveOptions& options = command.question.options;
  sub.add_option("--controller", command.controller,
                 "basic: drives over its cable; extended: keeps off it; retract: a reel keeps the cable taut")
      ->check(CLI::IsMember({"basic", "extended", "retract"}))
      ->capture_default_str();
  sub.add_option("--untangle", command.untangle, "how a way is found that the cable blocks")
      ->check(CLI::IsMember({"heuristic", "search", "both"}))
      ->capture_default_str();
  sub.add_option("--search-trials", options.search_trials, "motions that the search simulates for a goal at most")
      ->check(AtLeastOne())
      ->capture_default_str();
  CLI::Option* prevention =
      sub.add_option(
             "--deadlock-prevention", command.prevention,
             "areas: keeps out of places that a tether may lock; lookahead: visits goals so that later ones have "
             "a way; both")
          ->check(CLI::IsMember({"none", "areas", "lookahead", "both"}))
          ->capture_default_str();
  sub.add_flag("--no-deadlock-prevention", command.no_prevention, "as --deadlock-prevention none")
      ->excludes(prevention);
  sub.add_option("--lookahead-trials", options.lookahead_trials,
                 "motions that lookahead simulates at most for a goal that has no way")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub.add_flag("--keep-retreat", options.keep_retreat,
               "prefers motions after which the robot could drive back to its base");
}

}  // namespace

Run AddDrive(CLI::App& app) {
  const auto command = std::make_shared<DriveCommand>();
  CLI::App* sub = app.add_subcommand("drive", "the tethered robot driven to its goals with a simulated slack cable");
  AddCommonOptions(*sub, command->common);
  AddWayOptions(*sub, *command);
  sub->add_option("--goals", command->goals, "the goals of this file, `x y` in a line, - for standard input")
      ->type_name("FILE")
      ->check(InputName());
  sub->add_option("--resolution", command->resolution,
                  "the side of a cell; default: that of the map's own cells, without a map 0.1")
      ->type_name("METRES")
      ->check(Positive());
  sub->add_option("--connectivity", command->question.connectivity, "steps to 4 or 8 cells")
      ->check(FourOrEight())
      ->capture_default_str();
  AddRobotOptions(*sub, *command);
  sub->add_option("--max-nodes", command->question.max_vertices, "vertices of the manifold after which to stop")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub->add_option("--max-bytes", command->question.max_bytes, "bytes of memory of the manifold after which to stop")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub->add_option("--candidates", command->question.candidates,
                  "also, and in pictures instead: what untangling weighs before the goal of this number")
      ->type_name("NUMBER")
      ->check(AtLeastOne());
  sub->add_option("--animate", command->common.animate, "draw the drive to this SVG file, which moves in browsers")
      ->type_name("FILE")
      ->check(FileName());
  sub->footer(
      "Example:\n  tautline drive scenes/cable_hall.yaml --animate drive.svg\n"
      "Exit status: 0 solved, 2 bad input, 3 a goal was not visited (with the reason).");
  return [command] { return RunDrive(*command); };
}

}  // namespace tautline::cli
