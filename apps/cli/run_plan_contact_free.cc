// `tautline plan --contact-free`: a motion on which cable, robot and obstacles touch as little as possible.
#include <fmt/format.h>

#include <algorithm>

#include "apps/answers/contact_free_answer.h"
#include "apps/cli/describe.h"
#include "apps/cli/plan_command.h"
#include "apps/cli/progress_bar.h"
#include "apps/pictures/contact_free_pictures.h"
#include "tautline/scene/number_text.h"

namespace tautline::cli {
namespace {

std::string ToText(const ContactFreeAnswer& answer, double dt_s) {
  const ContactFreeResult& result = answer.result;
  if (result.status != ContactFreeStatus::kSolved) {
    return fmt::format("{}: {}.\n", result.status == ContactFreeStatus::kInfeasible ? "No motion" : "Stopped",
                       result.explanation);
  }
  const MotionCosts& costs = result.motion.costs;
  std::string text = fmt::format("Solved: the robot moves {} in {:.1f} s, turning on the spot for {:.1f} s of it.\n",
                                 Metres(costs.length_m), dt_s * costs.steps, dt_s * costs.turning_steps);
  if (result.contacts_proved()) {
    text += "  contacts none\n";
  } else {
    text += fmt::format("  contacts the cable touches obstacles for {:.1f} s, the robot stands on it for {:.1f} s\n",
                        dt_s * costs.cable_obstacle_steps, dt_s * costs.cable_robot_steps);
  }
  text += fmt::format("  cost     {:.4g}, and no motion costs less than {:.4g}\n", result.cost, result.bound);
  text += fmt::format("  shortest no way to the goal is shorter than {}\n", Metres(result.shortest_m));
  if (answer.verified) text += "  verified the motion was driven again, with the same contacts and costs\n";
  return text;
}

}  // namespace

Expected<int> RunPlanContactFree(const PlanCommand& command) {
  auto scene = ReadScene(command.common);
  if (!scene) return tl::unexpected(scene.error());
  if (command.robot_radius) scene->robot.radius = command.robot_radius;
  ProgressBar progress(!command.common.quiet);
  ContactFreeOptions options = command.contact_free_options;
  options.watch = progress.watcher();
  const auto answer = AnswerContactFree(*scene, options, command.common.verify);
  progress.Clear();
  if (!answer) return tl::unexpected(answer.error());
  return Deliver(command.common, {.json = answer->json,
                                  .text = ToText(*answer, options.env.dt_s),
                                  .draw = [&] { return DrawAnswer(*scene, *answer); },
                                  .animate = [&] { return AnimateAnswer(*scene, *answer); },
                                  .status = answer->status});
}

}  // namespace tautline::cli
