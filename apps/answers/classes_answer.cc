#include "apps/answers/classes_answer.h"

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "apps/answers/verification.h"
#include "tautline/homotopy/curve_faults.h"
#include "tautline/homotopy/word_path.h"
#include "tautline/planners/tether/explain.h"
#include "tautline/planners/tether/verify_plan.h"

namespace tautline {
namespace {

/// How many classes are listed when neither a length nor a count is given: on a map with many obstacles a tether has
/// hundreds of thousands.
constexpr std::int64_t kDefaultCount = 100;

/// The question with its ends and limits filled in. Errors: an end that neither question nor scene names.
Expected<ClassesQuestion> FillIn(ClassesQuestion question, const Scene& scene) {
  if (!question.from && !scene.tether) {
    return InvalidInput("no start; give --from X,Y or add a tether with its base to the scene", scene.path);
  }
  if (!question.to && !scene.goal) {
    return InvalidInput("no end; give --to X,Y or add `goal: [x, y]` to the scene", scene.path);
  }
  if (!question.from) question.from = scene.tether->base;
  if (!question.to) question.to = scene.goal;
  if (!question.options.max_length && !question.options.max_count) {
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

/// The shortest path of a word among those that leave and arrive in any sector: where obstacles touch, one sector may
/// have a class that another one lacks.
std::optional<TautPath> FindInAnySector(const TautSpace& space, Place from, Place to, const Word& word) {
  std::optional<TautPath> shortest;
  for (const Place& start : space.mesh().Sectors(from)) {
    for (const Place& end : space.mesh().Sectors(to)) {
      if (space.mesh().ComponentOf(start.triangle) != space.mesh().ComponentOf(end.triangle)) continue;
      auto path = FindWordPath(space, start, end, word);
      if (path && (!shortest || path->length < shortest->length)) shortest = std::move(path);
    }
  }
  return shortest;
}

/// The one class of a word. Errors: a name that no obstacle has.
Expected<Found> FindWord(const TetherPlanner& planner, const Socket& socket, Place goal,
                         const ClassesQuestion& question) {
  const auto word = ParseWord(*question.word, planner.space().rays().names());
  if (!word) return InvalidInput(word.error().message, "--word");
  // The word counts from the start on; the stub of a socket has written some of it when the walk begins.
  const Point stub[] = {socket.base, socket.exit.point};
  const Word from_exit = planner.space().rays().WordOf(stub).Inverse() * *word;
  auto path = FindInAnySector(planner.space(), socket.exit, goal, from_exit);
  if (!path) return Found{{}, "no_such_class", "no path between these points has the word '" + *question.word + "'"};
  if (socket.stub_length > 0) path->points.insert(path->points.begin(), socket.base);
  return Found{{{planner.space().MakePath(std::move(path->points))}, true, false}, "", ""};
}

Expected<Found> Find(const TetherPlanner& planner, const ClassesQuestion& question) {
  const TautSpace& space = planner.space();
  const auto socket = FindSocket(space, planner.ungrown(), *question.from);
  const auto goal = space.Locate(*question.to);
  if (!socket) {
    return Found{{}, "start_blocked", ExplainBlocked(space, "the start", *question.from)};
  }
  if (!goal) return Found{{}, "goal_blocked", ExplainBlocked(space, "the goal", *question.to)};
  if (!space.mesh().Connected(socket->exit, *goal)) {
    return Found{{}, "goal_unreachable", ExplainApart("the goal", *question.to, "the start")};
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

/// Whether a point belongs to several free sectors: obstacles touch there. From such a point, one word may name several
/// classes, since the obstacles share one ray.
bool IsTouchingPoint(const TautSpace& space, Point p) {
  const auto place = space.Locate(p);
  return place && space.mesh().Sectors(*place).size() > 1;
}

/// Every path is taut and free and no two are of one class.
std::vector<std::string> Faults(const Found& found, const TetherPlanner& planner, const ClassesQuestion& question) {
  const TautSpace& space = planner.space();
  std::vector<std::string> faults;
  std::set<Word> words;
  const FreeSpace* stub_space = space.Locate(*question.from) ? nullptr : &planner.ungrown_space();
  const bool words_tell = !IsTouchingPoint(space, *question.from) && !IsTouchingPoint(space, *question.to);
  for (const TautPath& path : found.list.classes) {
    for (const std::string& fault : CurveFaults(space.free_space(), path, stub_space)) {
      faults.push_back("a class's path " + fault);
    }
    if (!words.insert(path.word).second && words_tell) faults.emplace_back("a class is listed twice");
  }
  return faults;
}

}  // namespace

Expected<ClassesAnswer> AnswerClasses(const Scene& scene, const ClassesQuestion& question) {
  auto asked = FillIn(question, scene);
  if (!asked) return tl::unexpected(asked.error());
  auto planner = PreparePlanner(scene, question.preparation);
  if (!planner) return tl::unexpected(planner.error());
  auto found = Find(*planner, *asked);
  if (!found) return tl::unexpected(found.error());
  ClassesAnswer answer{.planner = std::move(*planner), .question = std::move(*asked)};
  const TautSpace& space = answer.planner.space();
  answer.json = ToJson(*found, space.free_space());
  answer.status = found->reason.empty() && !found->list.budget_exceeded ? kExitSolved : kExitInfeasible;
  if (MustVerify(question.verify)) {
    const int curves = static_cast<int>(found->list.classes.size());
    answer.verified_curves = ReportVerification(Faults(*found, answer.planner, answer.question), curves, answer.json);
  }
  answer.list = std::move(found->list);
  answer.explanation = std::move(found->explanation);
  return answer;
}

}  // namespace tautline
