// `tautline workspace tour`: the shortest tour over the tasks inside the workspace.
#include <fmt/format.h>

#include <memory>
#include <tuple>

#include "apps/answers/tour_answer.h"
#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "apps/cli/option_checks.h"
#include "apps/cli/point_option.h"
#include "apps/cli/progress_bar.h"
#include "apps/cli/workspace_commands.h"
#include "apps/pictures/workspace_pictures.h"
#include "tautline/scene/number_text.h"

namespace tautline::cli {
namespace {

/// Tasks listed in the text; JSON has all.
constexpr std::size_t kMostListed = 30;

struct TourCommand {
  CommonOptions common;
  std::string from;
  std::string to;
  TourQuestion question;
};

std::string ToText(const TourAnswer& answer) {
  if (answer.status != kExitSolved) return fmt::format("No tour: {}.\n", answer.explanation);
  const Tour& tour = **answer.tour;
  std::string text = fmt::format(
      "Tour of {} over {}, {}.\n", Metres(tour.path.length), Counted(tour.order.size(), "task", "tasks"),
      tour.optimal
          ? "the shortest"
          : fmt::format("at most {:.3g} % longer than the shortest", 100 * (tour.path.length / tour.bound - 1)));
  for (std::size_t i = 0; i < std::min(tour.order.size(), kMostListed); ++i) {
    const std::size_t task = tour.order[i];
    text += fmt::format("  {:>13}  task {:<3} {}\n", Metres(tour.legs[i].length), task + 1,
                        ToText(answer.stops.tasks[task]));
  }
  if (tour.order.size() > kMostListed) text += fmt::format("  ... and {} more\n", tour.order.size() - kMostListed);
  text += fmt::format("  {:>13}  {}\n", Metres(tour.legs.back().length),
                      answer.stops.goal ? "the goal " + ToText(*answer.stops.goal) : "back to the start");
  if (tour.outside) {
    text += fmt::format("  the path leaves the workspace at {}, beside a winch in the open\n", ToText(*tour.outside));
  }
  return text + DescribeVerification(answer.verified_curves);
}

Expected<int> RunTour(const TourCommand& command) {
  const auto scene = ReadScene(command.common);
  if (!scene) return tl::unexpected(scene.error());
  TourQuestion question = command.question;
  for (const auto& [text, option, to] :
       {std::tuple{&command.from, "--from", &question.from}, {&command.to, "--to", &question.to}}) {
    if (text->empty()) continue;
    const auto point = ParsePoint(*text, option);
    if (!point) return tl::unexpected(point.error());
    *to = *point;
  }
  question.seed = command.common.seed;
  question.verify = command.common.verify;
  ProgressBar progress(!command.common.quiet);
  question.options.watch = progress.watcher();
  const auto answer = AnswerTour(*scene, question);
  progress.Clear();
  if (!answer) return tl::unexpected(answer.error());
  const auto draw = [&] { return DrawAnswer(*scene, *answer); };
  return Deliver(command.common,
                 {.json = answer->json, .text = ToText(*answer), .draw = draw, .status = answer->status});
}

}  // namespace

Run AddWorkspaceTour(CLI::App& workspace) {
  const auto command = std::make_shared<TourCommand>();
  CLI::App* sub = workspace.add_subcommand("tour", "the shortest tour over the tasks, in any order");
  AddCommonOptions(*sub, command->common);
  sub->add_option("--from", command->from, "where the robot starts; without it, where the cables are laid")
      ->type_name("X,Y");
  sub->add_option("--to", command->to,
                  "where it ends; without it, at the scene's goal, or back at the start where there is none")
      ->type_name("X,Y");
  sub->add_flag("--round", command->question.round, "back to the start, whatever the scene's goal");
  sub->add_option("--rounds", command->question.options.rounds_per_task,
                  "for more than 15 tasks: rounds of the local search, for each task")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub->footer(
      "Example:\n  tautline workspace tour scenes/workspace.yaml --round --svg tour.svg\n"
      "Exit status: 0 solved, 2 bad input, 3 the start, a task or the goal is outside of the workspace, or there is "
      "none.");
  return [command] { return RunTour(*command); };
}

}  // namespace tautline::cli
