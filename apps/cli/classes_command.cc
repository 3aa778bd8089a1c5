// `tautline classes`: the homotopy classes between two points, shortest first.
#include <fmt/format.h>

#include <memory>
#include <utility>

#include "apps/answers/classes_answer.h"
#include "apps/cli/commands.h"
#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "apps/cli/option_checks.h"
#include "apps/cli/point_option.h"
#include "apps/cli/prepared_options.h"
#include "tautline/draw/draw_classes.h"
#include "tautline/planners/tether/prepared_file.h"
#include "tautline/scene/number_text.h"

namespace tautline::cli {
namespace {

struct ClassesCommand {
  CommonOptions common;
  ClassesQuestion question;
  std::string from;
  std::string to;
};

/// The question with the points that were given as text.
Expected<ClassesQuestion> Ask(const ClassesCommand& command) {
  ClassesQuestion question = command.question;
  question.verify = command.common.verify;
  if (!command.from.empty()) {
    const auto from = ParsePoint(command.from, "--from");
    if (!from) return tl::unexpected(from.error());
    question.from = *from;
  }
  if (!command.to.empty()) {
    const auto to = ParsePoint(command.to, "--to");
    if (!to) return tl::unexpected(to.error());
    question.to = *to;
  }
  return question;
}

std::string ToText(const ClassesAnswer& answer) {
  const ClassesQuestion& question = answer.question;
  if (answer.status != kExitSolved && !answer.list.budget_exceeded) {
    return fmt::format("No class: {}.\n", answer.explanation);
  }
  const std::vector<std::string> names = NamesOf(answer.planner.space().free_space());
  const std::size_t count = answer.list.classes.size();
  std::string text = Counted(count, "class", "classes");
  if (question.word) text += fmt::format(" of the word '{}'", *question.word);
  if (question.options.max_length && !question.word) {
    text += fmt::format(" up to {}", Metres(*question.options.max_length));
  }
  if (!answer.list.complete) {
    text += answer.list.budget_exceeded ? ", more exist: the budget ran out" : ", longer ones exist";
  }
  text += count == 0 ? ".\n" : ":\n";
  for (std::size_t i = 0; i < count; ++i) {
    const TautPath& path = answer.list.classes[i];
    text += fmt::format("  {:3}  {:>12}  {}\n", i + 1, Metres(path.length), Describe(path.word, names));
  }
  return text + DescribeVerification(answer.verified_curves);
}

Expected<int> RunClasses(const ClassesCommand& command) {
  const auto scene = ReadScene(command.common);
  if (!scene) return tl::unexpected(scene.error());
  auto question = Ask(command);
  if (!question) return tl::unexpected(question.error());
  ProgressBar progress(!command.common.quiet);
  auto preparation = ReadPreparation(command.common, progress);
  if (!preparation) return tl::unexpected(preparation.error());
  question->preparation = std::move(*preparation);
  question->options.keep_going = progress.Passing("classes");
  const auto answer = AnswerClasses(*scene, *question);
  progress.Clear();
  if (!answer) return tl::unexpected(answer.error());
  const auto draw = [&] {
    const ClassesQuestion& asked = answer->question;
    const ClassesPicture picture{.from = *asked.from, .to = *asked.to, .list = answer->list};
    return DrawClasses(*scene, answer->planner.space().free_space(), picture);
  };
  const auto prepared = [&] { return PreparedFile::Write(answer->planner, scene->world); };
  return Deliver(
      command.common,
      {.json = answer->json, .text = ToText(*answer), .draw = draw, .prepared = prepared, .status = answer->status});
}

}  // namespace

Run AddClasses(CLI::App& app) {
  const auto command = std::make_shared<ClassesCommand>();
  CLI::App* sub = app.add_subcommand("classes", "the homotopy classes between two points, shortest first");
  AddCommonOptions(*sub, command->common);
  AddPreparedOptions(*sub, command->common);
  sub->add_option("--from", command->from, "where the paths start; default: the tether's base")->type_name("X,Y");
  sub->add_option("--to", command->to, "where they end; default: the goal")->type_name("X,Y");
  CLI::Option* max_length =
      sub->add_option("--max-length", command->question.options.max_length, "only classes no longer than this")
          ->type_name("METRES")
          ->check(NonNegative());
  CLI::Option* count = sub->add_option("--count", command->question.options.max_count,
                                       "only so many, the shortest; default without both: 100 up to the tether");
  count->check(AtLeastOne());
  sub->add_option("--word", command->question.word, "only the class of this ray word, such as \"a b^-1\"")
      ->type_name("WORD")
      ->excludes(max_length)
      ->excludes(count);
  sub->add_option("--budget", command->question.options.budget, "search steps after which to stop")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub->footer(
      "Example:\n  tautline classes scenes/two_ways.yaml --count 5 --svg classes.svg\n"
      "Exit status: 0 solved, 2 bad input, 3 an end is blocked, no class has the word, or the budget ran out.");
  return [command] { return RunClasses(*command); };
}

}  // namespace tautline::cli
