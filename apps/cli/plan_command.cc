// `tautline plan`: the shortest motion that the tether allows.
#include "apps/cli/plan_command.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "apps/answers/plan_answer.h"
#include "apps/cli/commands.h"
#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "apps/cli/option_checks.h"
#include "apps/cli/prepared_options.h"
#include "apps/cli/progress_bar.h"
#include "tautline/draw/draw_plan.h"
#include "tautline/planners/tether/prepared_file.h"
#include "tautline/scene/number_text.h"

namespace tautline::cli {
namespace {

void DescribeAll(const PlanResult& result, const std::vector<std::string>& names, std::string& text) {
  if (result.all.empty()) return;
  text += fmt::format("\n{} that the tether allows{}, shortest motion first:\n",
                      Counted(result.all.size(), "class", "classes"), result.all_complete ? "" : " (there are more)");
  for (std::size_t i = 0; i < result.all.size(); ++i) {
    text += fmt::format("  {:3}  path {:>10}  tether {:>10}  class {}\n", i + 1, Metres(result.all[i].path.length),
                        Metres(result.all[i].tether.length), Describe(result.all[i].tether.word, names));
  }
}

/// The obstacles around which the rejected tether and the one of the answer wind differently: those that the loop of
/// the two encloses.
std::string EnclosedBetween(const PlanResult& result, const std::vector<std::string>& names) {
  if (!result.motion) return "";
  const Word loop = result.rejected->tether.word * result.motion->tether.word.Inverse();
  const std::vector<int> winding = Abelianize(loop, names.size());
  std::vector<std::string> enclosed;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (winding[i] != 0) enclosed.push_back(names[i]);
  }
  return fmt::format("{}", fmt::join(enclosed, ", "));
}

/// What it took to cross nothing.
std::string DescribeCrossingFree(const CrossingFree& facts, const std::vector<std::string>& names) {
  std::string text;
  if (facts.plain) {
    text += fmt::format("  crossing the shortest way, {}, would have the cable cross itself, class {}\n",
                        Metres(facts.plain->path.length), Describe(facts.plain->tether.word, names));
  }
  if (facts.around_base) text += "  around   the base: straight on, the tether would be pulled over it\n";
  text += fmt::format("  retreat  back along the cable and out again it would be {}\n", Metres(facts.retreat_length));
  if (!facts.optimal) {
    text += fmt::format("  bound    the budget ran out: a way without a crossing may be shorter, but not than {}\n",
                        Metres(facts.bound));
  }
  return text;
}

std::string ToText(const PlanResult& result, const FreeSpace& space) {
  const std::vector<std::string> names = NamesOf(space);
  std::string text;
  if (result.motion) {
    const Motion& motion = *result.motion;
    text += fmt::format("Solved: the robot moves {}.\n", Metres(motion.path.length));
    text += fmt::format("  path     {}\n", Describe(motion.path.points));
    text += fmt::format("  tether   at the goal {} of {} are needed, class {}\n", Metres(motion.tether.length),
                        Metres(result.limit), Describe(motion.tether.word, names));
  } else {
    text += fmt::format("{}: {}.\n", result.status == PlanStatus::kInfeasible ? "No motion" : "Stopped",
                        result.explanation);
  }
  if (!result.start.points.empty()) {
    text += fmt::format("  start    the cable as laid, pulled taut: {}, class {}\n", Metres(result.start.length),
                        Describe(result.start.word, names));
  }
  if (result.shortest_tether) {
    text += fmt::format("  needed   a tether of {}: {}\n", Metres(result.shortest_tether->length),
                        Describe(result.shortest_tether->points));
  }
  if (result.rejected) {
    const Motion& shorter = *result.rejected;
    const std::string enclosed = EnclosedBetween(result, names);
    text += fmt::format(
        "  rejected the shortest way, {}, would need {} of tether, {} more than there is: it leaves the tether "
        "wound{}, "
        "class {}\n",
        Metres(shorter.path.length), Metres(shorter.tether.length), Metres(shorter.tether.length - result.limit),
        enclosed.empty() ? " the wrong way" : " the wrong way around " + enclosed,
        Describe(shorter.tether.word, names));
  }
  if (result.crossing_free) text += DescribeCrossingFree(*result.crossing_free, names);
  DescribeAll(result, names, text);
  return text;
}

Expected<int> RunPlan(const PlanCommand& command) {
  if (!command.goals.empty()) return RunPlanGoals(command);
  if (command.field) return RunPlanField(command);
  if (command.contact_free) return RunPlanContactFree(command);
  const auto scene = ReadScene(command.common);
  if (!scene) return tl::unexpected(scene.error());
  ProgressBar progress(!command.common.quiet);
  auto preparation = ReadPreparation(command.common, progress);
  if (!preparation) return tl::unexpected(preparation.error());
  PlanOptions options = command.options;
  options.keep_going = progress.Passing("search");
  const auto answer =
      AnswerPlan(*scene, {.options = options, .verify = command.common.verify, .preparation = std::move(*preparation)});
  progress.Clear();
  if (!answer) return tl::unexpected(answer.error());
  const FreeSpace& space = answer->planner.space().free_space();
  const std::string text = ToText(answer->result, space) + DescribeVerification(answer->verified_curves);
  const auto draw = [&] { return DrawPlan(*scene, space, answer->result); };
  const auto prepared = [&] { return PreparedFile::Write(answer->planner, scene->world); };
  return Deliver(command.common,
                 {.json = answer->json, .text = text, .draw = draw, .prepared = prepared, .status = answer->status});
}

void AddContactFreeOptions(CLI::App& sub, CLI::Option& contact_free, PlanCommand& command) {
  ContactFreeOptions& options = command.contact_free_options;
  sub.add_option("--robot-radius", command.robot_radius,
                 "with --contact-free, of the robot's disc; default: the scene's, or 0.5")
      ->type_name("METRES")
      ->check(Positive())
      ->needs(&contact_free);
  sub.add_option("--length-cost", options.costs.per_metre,
                 "with --contact-free, of a metre; a step with the cable at an obstacle costs 1")
      ->check(NonNegative())
      ->capture_default_str()
      ->needs(&contact_free);
  sub.add_option("--animate", command.common.animate,
                 "with --contact-free, draw the motion to this SVG file, which moves in browsers")
      ->type_name("FILE")
      ->check(FileName())
      ->needs(&contact_free);
}

}  // namespace

Run AddPlan(CLI::App& app) {
  const auto command = std::make_shared<PlanCommand>();
  CLI::App* sub = app.add_subcommand("plan", "the shortest motion of the tethered robot that its tether allows");
  AddCommonOptions(*sub, command->common);
  const PreparedOptions prepared = AddPreparedOptions(*sub, command->common);
  CLI::Option* all =
      sub->add_flag("--all", command->options.all, "also list every class of the goal that the tether allows");
  sub->add_option("--count", command->options.max_all, "with --all, at most so many, those with the shortest tethers")
      ->check(AtLeastOne())
      ->capture_default_str();
  CLI::Option* crossing_free = sub->add_flag("--crossing-free", command->options.crossing_free,
                                             "the taut tether is never to cross itself on the way");
  const CLI::Option* budget = sub->add_option("--budget", command->options.budget, "search steps after which to stop")
                                  ->check(AtLeastOne())
                                  ->capture_default_str();
  CLI::Option* goals = sub->add_option("--goals", command->goals,
                                       "plan to each goal of this file, `x y` in a line, - for standard input, and "
                                       "print a line of JSON for each");
  goals->type_name("FILE")->check(InputName());
  CLI::Option* field = sub->add_flag("--field", command->field, "the next heading from every point of a grid");
  field->excludes(goals)->excludes(all)->excludes(crossing_free);
  sub->add_option("--resolution", command->resolution,
                  "with --field, between points of the grid; default: a hundredth of the longer side")
      ->type_name("METRES")
      ->check(Positive())
      ->needs(field);
  sub->add_option("--field-classes", command->field_classes,
                  "with --field, at each point the so many classes with the shortest tethers")
      ->check(AtLeastOne())
      ->capture_default_str()
      ->needs(field);
  CLI::Option* contact_free = sub->add_flag("--contact-free", command->contact_free,
                                            "a robot with a body drags a cable, which is to touch nothing");
  contact_free->excludes(goals)->excludes(all)->excludes(crossing_free)->excludes(field);
  contact_free->excludes(prepared.read)->excludes(prepared.write);
  AddContactFreeOptions(*sub, *contact_free, *command);
  sub->footer(
      "Example:\n  tautline plan scenes/two_ways.yaml --svg plan.svg\n"
      "  echo 3 2 | tautline plan scenes/two_ways.yaml --goals -\n"
      "Exit status: 0 solved, with --goals all of them, 2 bad input, 3 no solution (with the reason).");
  return [command, budget] {
    ContactFreeOptions& options = command->contact_free_options;
    if (budget->count() > 0) options.budget = options.last_search = command->options.budget;
    return RunPlan(*command);
  };
}

}  // namespace tautline::cli
