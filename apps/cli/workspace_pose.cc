// `tautline workspace pose`: the robot at one place of its workspace.
#include <fmt/format.h>

#include <memory>
#include <numbers>

#include "apps/answers/pose_answer.h"
#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "apps/cli/point_option.h"
#include "apps/cli/workspace_commands.h"
#include "apps/pictures/workspace_pictures.h"
#include "tautline/scene/number_text.h"

namespace tautline::cli {
namespace {

struct PoseCommand {
  CommonOptions common;
  std::string at;
};

std::string ToText(const PoseAnswer& answer) {
  if (answer.status != kExitSolved) return fmt::format("No pose: {}.\n", answer.explanation);
  const Pose& pose = *answer.pose;
  const char* where = pose.position == Containment::kInside ? "inside the workspace"
                      : pose.touches_obstacle               ? "on its boundary, touching blocked ground"
                                                            : "on its boundary, in the open";
  std::string text = fmt::format("The pose {} is {}.\n", ToText(answer.at), where);
  text += fmt::format("  the cables {} in every direction: widest angle {:.4g} degrees, margin {:.4g}\n",
                      pose.spans ? "can pull" : "cannot pull", pose.largest_gap * 180 / std::numbers::pi, pose.margin);
  for (std::size_t i = 0; i < pose.cables.size(); ++i) {
    text += fmt::format("  cable {:<3} {:>13}  {}\n", i + 1, Metres(pose.cables[i].length),
                        Describe(pose.cables[i].path.points));
  }
  return text + DescribeVerification(answer.verified_curves);
}

Expected<int> RunPose(const PoseCommand& command) {
  const auto scene = ReadScene(command.common);
  if (!scene) return tl::unexpected(scene.error());
  PoseQuestion question{.at = {}, .verify = command.common.verify};
  if (!command.at.empty()) {
    const auto at = ParsePoint(command.at, "--at");
    if (!at) return tl::unexpected(at.error());
    question.at = *at;
  }
  const auto answer = AnswerPose(*scene, question);
  if (!answer) return tl::unexpected(answer.error());
  const auto draw = [&] { return DrawAnswer(*scene, *answer); };
  return Deliver(command.common,
                 {.json = answer->json, .text = ToText(*answer), .draw = draw, .status = answer->status});
}

}  // namespace

Run AddWorkspacePose(CLI::App& workspace) {
  const auto command = std::make_shared<PoseCommand>();
  CLI::App* sub = workspace.add_subcommand("pose", "the taut cables at a place, and whether they can pull every way");
  AddCommonOptions(*sub, command->common);
  sub->add_option("--at", command->at, "the place of the robot; without it, where the cables are laid")
      ->type_name("X,Y");
  sub->footer(
      "Example:\n  tautline workspace pose scenes/workspace.yaml --at 90,90 --svg pose.svg\n"
      "Exit status: 0 solved, 2 bad input, 3 outside of the workspace, or there is none.");
  return [command] { return RunPose(*command); };
}

}  // namespace tautline::cli
