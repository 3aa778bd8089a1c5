// `tautline workspace move`: the motion to the goal inside the workspace, and what the winches do meanwhile.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "apps/answers/move_answer.h"
#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "apps/cli/option_checks.h"
#include "apps/cli/point_option.h"
#include "apps/cli/workspace_commands.h"
#include "apps/pictures/workspace_pictures.h"
#include "tautline/scene/number_text.h"

namespace tautline::cli {
namespace {

struct MoveCommand {
  CommonOptions common;
  std::string from;
  std::string to;
  MoveOptions options;
  double acceleration = 0;  ///< 0: absent.
  double dt = 0;            ///< 0: absent.
};

/// What a winch does in the course of a motion.
std::string DescribeWinch(const MoveAnswer& answer, std::size_t winch) {
  const std::vector<MoveSample>& samples = answer.samples;
  double fastest = 0;
  for (const MoveSample& sample : samples) {
    if (std::fabs(sample.rates[winch]) > std::fabs(fastest)) fastest = sample.rates[winch];
  }
  const std::vector<CornerSwitch>& switches = (*answer.move)->switches;
  const auto count = static_cast<std::size_t>(
      std::count_if(switches.begin(), switches.end(), [winch](const CornerSwitch& s) { return s.anchor == winch; }));
  return fmt::format("  winch {:<3} {:>13} -> {:>13}, fastest {} m/s, {}\n", winch + 1,
                     Metres(samples.front().lengths[winch]), Metres(samples.back().lengths[winch]),
                     ShortNumber(fastest), Counted(count, "switch of its corner", "switches of its corner"));
}

std::string ToText(const MoveAnswer& answer) {
  if (answer.status != kExitSolved) return fmt::format("No motion: {}.\n", answer.explanation);
  const Move& move = **answer.move;
  std::string text =
      fmt::format("Motion of {} in {} s, {}.\n  path {}\n", Metres(move.path.length), ShortNumber(move.duration_s),
                  Counted(answer.samples.size(), "sample", "samples"), Describe(move.path.points));
  for (std::size_t i = 0; i < answer.setup.anchors.size(); ++i) text += DescribeWinch(answer, i);
  if (move.outside) {
    text += fmt::format("  the path leaves the workspace at {}, beside a winch in the open\n", ToText(*move.outside));
  }
  return text + DescribeVerification(answer.verified_curves);
}

Expected<MoveQuestion> QuestionOf(const MoveCommand& command) {
  MoveQuestion question{.options = command.options, .verify = command.common.verify};
  for (const auto& [text, option, to] :
       {std::tuple{&command.from, "--from", &question.from}, {&command.to, "--to", &question.to}}) {
    if (text->empty()) continue;
    const auto point = ParsePoint(*text, option);
    if (!point) return tl::unexpected(point.error());
    *to = *point;
  }
  if (command.acceleration > 0) question.options.acceleration = command.acceleration;
  if (command.dt > 0) question.dt = command.dt;
  return question;
}

Expected<int> RunMove(const MoveCommand& command) {
  const auto scene = ReadScene(command.common);
  if (!scene) return tl::unexpected(scene.error());
  const auto question = QuestionOf(command);
  if (!question) return tl::unexpected(question.error());
  const auto answer = AnswerMove(*scene, *question);
  if (!answer) return tl::unexpected(answer.error());
  const auto draw = [&] { return DrawAnswer(*scene, *answer); };
  const auto csv = [&] { return MoveCsv(*answer); };
  return Deliver(command.common,
                 {.json = answer->json, .text = ToText(*answer), .draw = draw, .csv = csv, .status = answer->status});
}

}  // namespace

Run AddWorkspaceMove(CLI::App& workspace) {
  const auto command = std::make_shared<MoveCommand>();
  CLI::App* sub =
      workspace.add_subcommand("move", "the shortest motion to the goal, with all cables' lengths and rates over time");
  AddCommonOptions(*sub, command->common);
  sub->add_option("--from", command->from, "where the robot starts; without it, where the cables are laid")
      ->type_name("X,Y");
  sub->add_option("--to", command->to, "where it goes; without it, to the scene's goal")->type_name("X,Y");
  sub->add_option("--speed", command->options.speed, "the most, metres per second")
      ->check(Positive())
      ->capture_default_str();
  sub->add_option("--acceleration", command->acceleration,
                  "speed up and slow down so fast, metres per second squared; without it the speed is constant")
      ->check(Positive());
  sub->add_option("--winch-limit", command->options.winch_limits,
                  "the most that winches reel in or pay out, metres per second: one number, or one for each")
      ->type_name("R[,R...]")
      ->delimiter(',')
      ->check(Positive());
  sub->add_option("--dt", command->dt, "seconds between samples; without it, a 200th of the motion")->check(Positive());
  sub->add_option("--csv", command->common.csv, "write the samples to this file as a table")
      ->type_name("FILE")
      ->check(FileName());
  sub->footer(
      "Example:\n  tautline workspace move scenes/workspace.yaml --acceleration 0.5 --svg move.svg --csv move.csv\n"
      "Exit status: 0 solved, 2 bad input, 3 the start or the goal is outside of the workspace, or there is none.");
  return [command] { return RunMove(*command); };
}

}  // namespace tautline::cli
