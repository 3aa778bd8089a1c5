// `tautline learn evaluate`: what a policy does on a scene.
#include <fmt/format.h>

#include <memory>
#include <string>

#include "apps/answers/learn_answer.h"
#include "apps/cli/common_options.h"
#include "apps/cli/learn_commands.h"
#include "apps/cli/option_checks.h"
#include "apps/cli/progress_bar.h"
#include "apps/pictures/learn_pictures.h"
#include "tautline/scene/number_text.h"
#include "tautline/scene/text_file.h"

namespace tautline::cli {
namespace {

/// A policy of the largest network that can be trained is smaller.
constexpr std::size_t kMostBytes = std::size_t{1} << 30;

struct LearnEvaluateCommand {
  CommonOptions common;
  std::string policy;
  std::string kernels = "auto";
};

std::string ToText(const LearnAnswer& answer) {
  if (!answer.reference) return fmt::format("No reference path: {}.\n", answer.explanation);
  const Json& json = answer.json;
  std::string text =
      answer.explanation.empty()
          ? fmt::format("The goal is reached in {} s and {}; the reference has {}.\n", ShortNumber(json["time"]),
                        Metres(json["length"]), Metres(answer.reference->length_m))
          : fmt::format("Not reached: {}.\n", answer.explanation);
  return text + fmt::format("  cable at obstacles {:>8} times a minute\n  cable under robot  {:>8} times a minute\n",
                            ShortNumber(json["cable_obstacle_per_minute"]),
                            ShortNumber(json["cable_robot_per_minute"]));
}

Expected<int> RunLearnEvaluate(const LearnEvaluateCommand& command) {
  if (auto kept = KeepInput(command.common, command.policy); !kept) return tl::unexpected(kept.error());
  const auto scene = ReadScene(command.common);
  if (!scene) return tl::unexpected(scene.error());
  const auto policy = ReadTextFile(command.policy, kMostBytes);
  if (!policy) return tl::unexpected(policy.error());
  const Kernels* const kernels = FindKernels(command.kernels);
  if (kernels == nullptr) {
    return InvalidInput("this processor, or this build, has no such kernels; give auto",
                        "--kernels " + command.kernels);
  }
  ProgressBar progress(!command.common.quiet);
  const auto answer = AnswerLearnEvaluate(
      *scene, {.policy = *policy, .name = command.policy, .kernels = kernels, .watch = progress.watcher()});
  progress.Clear();
  if (!answer) return tl::unexpected(answer.error());
  return Deliver(command.common, {.json = answer->json,
                                  .text = ToText(*answer),
                                  .draw = [&] { return DrawAnswer(*scene, *answer); },
                                  .animate = [&] { return AnimateAnswer(*scene, *answer); },
                                  .status = answer->status});
}

}  // namespace

Run AddLearnEvaluate(CLI::App& learn) {
  const auto command = std::make_shared<LearnEvaluateCommand>();
  CLI::App* sub = learn.add_subcommand("evaluate", "the drive of a policy: its path, and what touched what");
  AddCommonOptions(*sub, command->common);
  sub->add_option("--policy", command->policy, "the policy: an ONNX file that `learn train` wrote")
      ->required()
      ->type_name("FILE")
      ->check(FileName());
  sub->add_option("--kernels", command->kernels, "the loops of the network; auto: the widest that the processor has")
      ->check(CLI::IsMember({"auto", "portable", "avx2", "avx512"}))
      ->capture_default_str();
  sub->add_option("--animate", command->common.animate, "draw the drive to this SVG file, which moves in browsers")
      ->type_name("FILE")
      ->check(FileName());
  sub->footer(
      "Example:\n  tautline learn evaluate scenes/quiet_room.yaml --policy scenes/quiet_room.onnx --svg path.svg\n"
      "Exit status: 0 solved, 2 bad input, 3 no reference path, or the goal was not reached (with the reason).");
  return [command] { return RunLearnEvaluate(*command); };
}

}  // namespace tautline::cli
