// `tautline classes`: the homotopy classes between two points, shortest first.
#include <fmt/format.h>

#include <memory>
#include <set>

#include "apps/cli/commands.h"
#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/json_values.h"
#include "apps/cli/option_checks.h"
#include "apps/cli/point_option.h"
#include "apps/cli/verification.h"
#include "tautline/draw/draw_classes.h"
#include "tautline/homotopy/word_path.h"
#include "tautline/planners/tether/explain.h"
#include "tautline/planners/tether/tether_planner.h"
#include "tautline/planners/tether/verify_plan.h"

namespace tautline::cli {
namespace {

/// How many classes are listed when neither a length nor a count is given: on a map with many obstacles a tether has
/// hundreds of thousands.
constexpr std::int64_t kDefaultCount = 100;

struct ClassesCommand {
  CommonOptions common;
  ClassOptions options;
  std::string from;
  std::string to;
  std::optional<std::string> word;
};

/// The question with its ends filled in.
struct Question {
  Point from;
  Point to;
  ClassOptions options;
  std::optional<std::string> word;  ///< Only the class of this word.
};

Expected<Question> Ask(const ClassesCommand& command, const Scene& scene) {
  Question question{{}, {}, command.options, command.word};
  if (command.from.empty() && !scene.tether) {
    return InvalidInput("no start; give --from X,Y or add a tether with its base to the scene", scene.path);
  }
  if (command.to.empty() && !scene.goal) {
    return InvalidInput("no end; give --to X,Y or add `goal: [x, y]` to the scene", scene.path);
  }
  const auto from = command.from.empty() ? Expected<Point>(scene.tether->base) : ParsePoint(command.from, "--from");
  if (!from) return tl::unexpected(from.error());
  const auto to = command.to.empty() ? Expected<Point>(*scene.goal) : ParsePoint(command.to, "--to");
  if (!to) return tl::unexpected(to.error());
  question.from = *from;
  question.to = *to;
  if (!command.options.max_length && !command.options.max_count) {
    if (scene.tether) question.options.max_length = scene.tether->length;
    question.options.max_count = kDefaultCount;
  }
  return question;
}

/// The classes, or why there can be none.
struct Found {
  ClassList list;
  std::string reason;
  std::string explanation;
};

/// The one class of a word. Errors: a name that no obstacle has.
Expected<Found> FindWord(const TetherPlanner& planner, const Socket& socket, Place goal, const Question& question) {
  const auto word = ParseWord(*question.word, planner.space().rays().names());
  if (!word) return InvalidInput(word.error().message, "--word");
  // The word counts from the start on; the stub of a socket has written some of it when the walk begins.
  const Point stub[] = {socket.base, socket.exit.point};
  const Word from_exit = planner.space().rays().WordOf(stub).Inverse() * *word;
  auto path = FindWordPath(planner.space(), socket.exit, goal, from_exit);
  if (!path) return Found{{}, "no_such_class", "no path between these points has the word '" + *question.word + "'"};
  if (socket.stub_length > 0) path->points.insert(path->points.begin(), socket.base);
  return Found{{{planner.space().MakePath(std::move(path->points))}, true, false}, "", ""};
}

Expected<Found> Find(const TetherPlanner& planner, const Question& question) {
  const TautSpace& space = planner.space();
  const auto socket = FindSocket(space, planner.ungrown(), question.from);
  const auto goal = space.Locate(question.to);
  if (!socket) {
    return Found{{}, "start_blocked", ExplainBlocked(space, "the start", question.from)};
  }
  if (!goal) return Found{{}, "goal_blocked", ExplainBlocked(space, "the goal", question.to)};
  if (!space.mesh().Connected(socket->exit, *goal)) {
    return Found{{}, "goal_unreachable", ExplainUnreachable(question.to)};
  }
  if (question.word) return FindWord(planner, *socket, *goal, question);
  Found found{planner.TethersTo(*socket, Walk(socket->exit), *goal, question.options), "", ""};
  if (found.list.budget_exceeded) found.explanation = ExplainBudget(question.options.budget);
  return found;
}

Json ToJson(const Found& found, const FreeSpace& space) {
  const JsonValues values(space);
  Json json;
  json["command"] = "classes";
  json["status"] = !found.reason.empty() ? "infeasible" : found.list.budget_exceeded ? "budget_exceeded" : "solved";
  if (!found.reason.empty() || found.list.budget_exceeded) {
    json["reason"] = found.reason.empty() ? "budget_exceeded" : found.reason;
    json["explanation"] = found.explanation;
  }
  json["classes"] = Json::array();
  for (const TautPath& path : found.list.classes) json["classes"].push_back(values.Of(path, "path"));
  json["complete"] = found.list.complete;
  return json;
}

std::string ToText(const Found& found, const Question& question, const FreeSpace& space) {
  if (!found.reason.empty()) return fmt::format("No class: {}.\n", found.explanation);
  const std::vector<std::string> names = NamesOf(space);
  const std::size_t count = found.list.classes.size();
  std::string text = Counted(count, "class", "classes");
  if (question.word) text += fmt::format(" of the word '{}'", *question.word);
  if (question.options.max_length && !question.word) {
    text += fmt::format(" up to {}", Metres(*question.options.max_length));
  }
  if (!found.list.complete) {
    text += found.list.budget_exceeded ? ", more exist: the budget ran out" : ", longer ones exist";
  }
  text += count == 0 ? ".\n" : ":\n";
  for (std::size_t i = 0; i < count; ++i) {
    const TautPath& path = found.list.classes[i];
    text += fmt::format("  {:3}  {:>12}  {}\n", i + 1, Metres(path.length), Describe(path.word, names));
  }
  return text;
}

/// Whether a point belongs to several free sectors: obstacles touch there. From such a point, one word may name several
/// classes, since the obstacles share one ray.
bool IsTouchingPoint(const TautSpace& space, Point p) {
  const auto place = space.Locate(p);
  return place && space.mesh().Sectors(*place).size() > 1;
}

/// Every path is taut and free and no two are of one class.
std::vector<std::string> Faults(const Found& found, const TautSpace& space, const Question& question) {
  std::vector<std::string> faults;
  std::set<Word> words;
  const bool has_stub = !space.Locate(question.from);
  const bool words_tell = !IsTouchingPoint(space, question.from) && !IsTouchingPoint(space, question.to);
  for (const TautPath& path : found.list.classes) {
    for (const std::string& fault : CurveFaults(space.free_space(), path, has_stub)) {
      faults.push_back("a class's path " + fault);
    }
    if (!words.insert(path.word).second && words_tell) faults.emplace_back("a class is listed twice");
  }
  return faults;
}

int StatusOf(const Found& found) {
  return !found.reason.empty() || found.list.budget_exceeded ? kExitInfeasible : kExitSolved;
}

Expected<int> RunClasses(const ClassesCommand& command) {
  const auto scene = ReadScene(command.common);
  if (!scene) return tl::unexpected(scene.error());
  const auto question = Ask(command, *scene);
  if (!question) return tl::unexpected(question.error());
  const auto planner = TetherPlanner::Prepare(scene->world);
  if (!planner) return tl::unexpected(planner.error());
  const auto asked = Find(*planner, *question);
  if (!asked) return tl::unexpected(asked.error());
  const Found& found = *asked;
  const FreeSpace& space = planner->space().free_space();
  Json json = ToJson(found, space);
  std::string text = ToText(found, *question, space);
  if (MustVerify(command.common)) {
    const std::vector<std::string> faults = Faults(found, planner->space(), *question);
    ReportVerification(faults, static_cast<int>(found.list.classes.size()), json, text);
  }
  const auto draw = [&] {
    return DrawClasses(*scene, space, {.from = question->from, .to = question->to, .list = found.list});
  };
  return Deliver(command.common, {.json = json, .text = text, .draw = draw, .status = StatusOf(found)});
}

}  // namespace

Run AddClasses(CLI::App& app) {
  const auto command = std::make_shared<ClassesCommand>();
  CLI::App* sub = app.add_subcommand("classes", "the homotopy classes between two points, shortest first");
  AddCommonOptions(*sub, command->common);
  sub->add_option("--from", command->from, "where the paths start; default: the tether's base")->type_name("X,Y");
  sub->add_option("--to", command->to, "where they end; default: the goal")->type_name("X,Y");
  CLI::Option* max_length =
      sub->add_option("--max-length", command->options.max_length, "only classes no longer than this")
          ->type_name("METRES")
          ->check(NonNegative());
  CLI::Option* count = sub->add_option("--count", command->options.max_count,
                                       "only so many, the shortest; default without both: 100 up to the tether");
  count->check(AtLeastOne());
  sub->add_option("--word", command->word, "only the class of this ray word, such as \"a b^-1\"")
      ->type_name("WORD")
      ->excludes(max_length)
      ->excludes(count);
  sub->add_option("--budget", command->options.budget, "search steps after which to stop")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub->footer(
      "Example:\n  tautline classes scenes/two_ways.yaml --count 5 --svg classes.svg\n"
      "Exit status: 0 solved, 2 bad input, 3 an end is blocked, no class has the word, or the budget ran out.");
  return [command] { return RunClasses(*command); };
}

}  // namespace tautline::cli
