// `tautline fleet plan`: the motion of all robots to the layout of their cable lines.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <stdexcept>

#include "apps/answers/fleet_plan_answer.h"
#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "apps/cli/fleet_commands.h"
#include "apps/cli/option_checks.h"
#include "apps/cli/output_file.h"
#include "apps/cli/progress_bar.h"
#include "apps/pictures/fleet_pictures.h"
#include "tautline/draw/draw_fleet.h"
#include "tautline/scene/number_text.h"

namespace tautline::cli {
namespace {

/// Lines of a list in the text; JSON has all.
constexpr std::size_t kMostListed = 30;

struct FleetPlanCommand {
  CommonOptions common;
  std::string mode = "straight-concurrent";
  bool speeds = false;
  double gap = -1;  ///< Negative: absent.
  std::int64_t budget = FleetPlanQuestion().budget;
};

std::string NamesOf(const FleetPlanAnswer& answer, const std::vector<RobotId>& robots) {
  std::string names;
  for (std::size_t i = 0; i < std::min(robots.size(), kMostListed); ++i) {
    names += (i == 0 ? "" : ", ") + answer.setup.name(robots[i]);
  }
  if (robots.size() > kMostListed) names += fmt::format(" and {} more", robots.size() - kMostListed);
  return names;
}

std::string DescribeOrders(const FleetPlanAnswer& answer) {
  std::string text;
  const auto& passings = answer.plan->passings;
  for (std::size_t i = 0; i < std::min(passings.size(), kMostListed); ++i) {
    const Passing& passing = passings[i];
    text += fmt::format("  {:<3} {} before {}, at {}\n", passing.label, answer.setup.name(passing.first),
                        answer.setup.name(passing.second), ShortText(passing.at));
  }
  if (passings.size() > kMostListed) text += fmt::format("  ... and {} more\n", passings.size() - kMostListed);
  return text;
}

std::string DescribeWaits(const FleetPlanAnswer& answer) {
  std::string text;
  std::size_t count = 0;
  for (std::size_t i = 0; i < answer.plan->schedule.size(); ++i) {
    const RobotSchedule& robot = answer.plan->schedule[i];
    for (const FleetEvent& event : robot.events) {
      if (event.departure <= event.arrival || ++count > kMostListed) continue;
      text += fmt::format("  {} waits at {} from {} to {} s\n", answer.setup.name(RobotId(i)), ShortText(event.at),
                          ShortNumber(event.arrival), ShortNumber(event.departure));
    }
  }
  if (count > kMostListed) text += fmt::format("  ... and {} more\n", count - kMostListed);
  return text;
}

std::string DescribeModes(const FleetPlan& plan) {
  std::string text;
  for (const FleetMode mode : {FleetMode::kStraightConcurrent, FleetMode::kStraightSequential,
                               FleetMode::kBentConcurrent, FleetMode::kBentSequential}) {
    const ModeSummary& summary = plan.modes[static_cast<std::size_t>(mode)];
    text += fmt::format("  {:<20} {:>10} s {:>13}{}\n", ToString(mode), ShortNumber(summary.travel_time),
                        Metres(summary.travel_distance),
                        summary.realizable ? "" : ", with " + Counted(summary.detours.size(), "detour", "detours"));
  }
  return text;
}

std::string ToText(const FleetPlanAnswer& answer) {
  if (!answer.plan) return fmt::format("No plan: {}.\n", answer.explanation);
  const FleetPlan& plan = *answer.plan;
  std::string text =
      fmt::format("Plan for {}, {}: {} s, {} in all.\n", Counted(plan.schedule.size(), "robot", "robots"),
                  ToString(plan.mode), ShortNumber(plan.travel_time), Metres(plan.travel_distance));
  if (answer.chosen) {
    text += fmt::format("  the layout was chosen: {} of cable, {}\n", Metres(answer.chosen->length),
                        answer.chosen->optimal ? "and none is better" : "there may be better ones");
  }
  if (!plan.detours.empty()) text += "  along their cable lines: " + NamesOf(answer, plan.detours) + "\n";
  return text + DescribeOrders(answer) + DescribeWaits(answer) + DescribeModes(plan);
}

/// Writes what reproduces a contradicted plan to the current folder, and says where.
[[noreturn]] void Report(const FleetPlanContradicted& fault) {
  const std::string text = fault.report().dump(1) + "\n";
  // FNV-1a: names the file by what is in it.
  std::uint64_t digest = 0xcbf29ce484222325U;
  for (const char c : text) digest = (digest ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  const std::string path = fmt::format("tautline-fleet-fault-{:016x}.json", digest);
  OutputFiles files;
  auto written = files.Add(path, text);
  if (written) written = files.Commit();
  throw std::logic_error(fault.what() + (written ? "; " + path + " reproduces it" : "; " + ToString(written.error())));
}

Expected<FleetPlanAnswer> AnswerOrReport(const Scene& scene, const FleetPlanQuestion& question) {
  try {
    return AnswerFleetPlan(scene, question);
  } catch (const FleetPlanContradicted& fault) {
    Report(fault);
  }
}

Expected<int> RunFleetPlan(const FleetPlanCommand& command) {
  const auto scene = ReadScene(command.common);
  if (!scene) return tl::unexpected(scene.error());
  ProgressBar progress(!command.common.quiet);
  FleetPlanQuestion question;
  question.options.mode = *FleetModeNamed(command.mode);
  question.options.speeds = command.speeds;
  if (command.gap >= 0) question.options.gap = command.gap;
  question.budget = command.budget;
  question.options.watch = progress.watcher();
  if (!command.common.animate.empty() && scene->fleet) {
    question.playback.frames = FilmFrames(scene->fleet->robots.size());
  }
  const auto answer = AnswerOrReport(*scene, question);
  progress.Clear();
  if (!answer) return tl::unexpected(answer.error());
  const auto draw = [&] { return DrawAnswer(*scene, *answer); };
  const auto animate = [&] { return AnimateAnswer(*scene, *answer); };
  const auto csv = [&] { return answer->plan ? FleetPlanCsv(*answer) : std::string(); };
  return Deliver(command.common, {.json = answer->json,
                                  .text = ToText(*answer),
                                  .draw = draw,
                                  .csv = csv,
                                  .animate = animate,
                                  .status = answer->status});
}

}  // namespace

Run AddFleetPlan(CLI::App& fleet) {
  const auto command = std::make_shared<FleetPlanCommand>();
  CLI::App* sub = fleet.add_subcommand(
      "plan", "the motion of all robots to the layout of their cable lines, or to the one that takes the least time");
  AddCommonOptions(*sub, command->common);
  sub->add_option("--mode", command->mode, "along the shortest paths or the cable lines, all at once or one by one")
      ->check(CLI::IsMember({"straight-concurrent", "straight-sequential", "bent-concurrent", "bent-sequential"}))
      ->capture_default_str();
  sub->add_flag("--speeds", command->speeds, "drive slower instead of waiting");
  sub->add_option("--gap", command->gap,
                  "how far apart robots stay at a crossing, metres; without it, the sum of their radii")
      ->check(NonNegative());
  sub->add_option("--budget", command->budget, "without cable lines, orders of passing after which the choice ends")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub->add_option("--csv", command->common.csv, "write the events to this file as a table")
      ->type_name("FILE")
      ->check(FileName());
  sub->add_option("--animate", command->common.animate, "draw the motion to this SVG file, which moves in browsers")
      ->type_name("FILE")
      ->check(FileName());
  sub->footer(
      "Example:\n  tautline fleet plan scenes/fleet.yaml --svg fleet.svg\n"
      "Exit status: 0 solved, 2 bad input, 3 the layout cannot be had, or not with this gap or these tethers.");
  return [command] { return RunFleetPlan(*command); };
}

}  // namespace tautline::cli
