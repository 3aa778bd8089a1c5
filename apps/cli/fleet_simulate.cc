// `tautline fleet simulate`: a plan played with taut cables that robots push.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <sstream>

#include "apps/answers/simulate_answer.h"
#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "apps/cli/fleet_commands.h"
#include "apps/cli/option_checks.h"
#include "apps/cli/progress_bar.h"
#include "apps/pictures/fleet_pictures.h"
#include "tautline/draw/draw_fleet.h"
#include "tautline/scene/number_text.h"

namespace tautline::cli {
namespace {

/// Cables listed in the text; JSON has all.
constexpr std::size_t kMostListed = 20;

struct SimulateCommand {
  CommonOptions common;
  std::string mode = "straight-concurrent";
  std::vector<std::string> order;
  std::string plan;
};

std::string ToText(const SimulateAnswer& answer) {
  if (!answer.playback) return fmt::format("It does not come out: {}.\n", answer.explanation);
  const Playback& playback = *answer.playback;
  const FleetGround& ground = answer.setup.ground;
  std::string text = answer.status == kExitSolved ? std::string("The layout comes out, and every order is kept.\n")
                                                  : fmt::format("It does not come out: {}.\n", answer.explanation);
  const std::size_t count = playback.final_routes.size();
  for (std::size_t i = 0; i < std::min(count, kMostListed); ++i) {
    const bool differs = std::binary_search(playback.differing.begin(), playback.differing.end(), RobotId(i));
    text += fmt::format("  {:<8} {:>12}, at most {:>12}{}  {}\n", answer.setup.name(RobotId(i)),
                        Metres(LengthOf(ground, playback.final_routes[i])), Metres(playback.longest[i].length),
                        differs ? "  differs" : "", Describe(PointsOf(ground, playback.final_routes[i])));
  }
  if (count > kMostListed) text += fmt::format("  ... and {} more\n", count - kMostListed);
  for (std::size_t k = 0; k < std::min(playback.broken.size(), kMostListed); ++k) {
    const BrokenOrder& order = playback.broken[k];
    text += fmt::format("  {} should pass {} before {} and does not\n", answer.setup.name(order.first),
                        ShortText(order.at), answer.setup.name(order.second));
  }
  return text;
}

Expected<SimulateQuestion> QuestionOf(const SimulateCommand& command) {
  SimulateQuestion question{
      .mode = *FleetModeNamed(command.mode), .order = command.order, .plan = {}, .plan_file = command.plan};
  if (command.plan.empty()) return question;
  std::ifstream file(command.plan);
  std::ostringstream text;
  if (file) text << file.rdbuf();
  if (!file) return tl::unexpected(Error{ErrorCode::kUnreadable, "cannot be read", command.plan});
  question.plan = Json::parse(text.str(), nullptr, false);
  if (question.plan->is_discarded()) {
    return InvalidInput("this is not JSON: give the result of `fleet plan --json`", command.plan);
  }
  return question;
}

Expected<int> RunSimulate(const SimulateCommand& command) {
  const auto scene = ReadScene(command.common, command.plan);
  if (!scene) return tl::unexpected(scene.error());
  auto question = QuestionOf(command);
  if (!question) return tl::unexpected(question.error());
  ProgressBar progress(!command.common.quiet);
  question->watch = progress.watcher();
  if (!command.common.animate.empty() && scene->fleet) question->frames = FilmFrames(scene->fleet->robots.size());
  const auto answer = AnswerSimulate(*scene, *question);
  progress.Clear();
  if (!answer) return tl::unexpected(answer.error());
  const auto draw = [&] { return DrawAnswer(*scene, *answer); };
  const auto animate = [&] { return AnimateAnswer(*scene, *answer); };
  return Deliver(
      command.common,
      {.json = answer->json, .text = ToText(*answer), .draw = draw, .animate = animate, .status = answer->status});
}

}  // namespace

Run AddFleetSimulate(CLI::App& fleet) {
  const auto command = std::make_shared<SimulateCommand>();
  CLI::App* sub = fleet.add_subcommand("simulate", "a plan played with taut cables that robots push");
  AddCommonOptions(*sub, command->common);
  CLI::Option* mode =
      sub->add_option("--mode", command->mode, "plan in this mode, and play the plan")
          ->check(CLI::IsMember({"straight-concurrent", "straight-sequential", "bent-concurrent", "bent-sequential"}))
          ->capture_default_str();
  CLI::Option* order =
      sub->add_option("--order", command->order, "instead: all robots straight, one after the other, in this order")
          ->type_name("ROBOT[,ROBOT...]")
          ->delimiter(',');
  sub->add_option("--plan", command->plan, "instead: play this result of `fleet plan --json`")
      ->type_name("FILE")
      ->check(FileName())
      ->excludes(mode)
      ->excludes(order);
  order->excludes(mode);
  sub->add_option("--animate", command->common.animate, "draw the motion to this SVG file, which moves in browsers")
      ->type_name("FILE")
      ->check(FileName());
  sub->footer(
      "Example:\n  tautline fleet simulate scenes/fleet.yaml --order r1,r2,r3 --svg wrong.svg\n"
      "Exit status: 0 the layout comes out, 2 bad input, 3 it does not.");
  return [command] { return RunSimulate(*command); };
}

}  // namespace tautline::cli
