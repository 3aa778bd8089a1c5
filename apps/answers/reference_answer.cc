#include "apps/answers/reference_answer.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "apps/answers/verification.h"
#include "tautline/homotopy/curve_faults.h"
#include "tautline/planners/contact_free/homotopic_dijkstra.h"
#include "tautline/planners/contact_free/homotopic_voronoi.h"
#include "tautline/planners/contact_free/path_lattice.h"
#include "tautline/planners/contact_free/tether_env.h"
#include "tautline/planners/contact_free/yen_reference.h"
#include "tautline/scene/check_tether.h"

namespace tautline {
namespace {

/// Of a robot of which nothing is said. [Shimada2024, Sec. 5.3]
constexpr double kUsualRadius = 0.5;

/// Milliseconds since it was made.
class Clock {
 public:
  double ms() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

Json ToJson(const JsonValues& values, const ReferenceCandidate& candidate) {
  Json json = values.Of(candidate.path, "path");
  json["tether"]["word"] = values.Of(candidate.tether_word);
  if (candidate.tether) json["tether"]["length"] = candidate.tether->length;
  json["fits"] = candidate.fits;
  return json;
}

/// What both ways have: the outcome, the reference and the classes.
void AddSelection(const JsonValues& values, const ReferenceSelection& selection, double limit, Json& json) {
  const bool gave_up = selection.outcome == ReferenceOutcome::kBudgetExceeded;
  json["status"] = selection.reference ? "solved" : gave_up ? "budget_exceeded" : "infeasible";
  if (!selection.reference) {
    json["reason"] = ToString(selection.outcome);
    json["explanation"] = selection.explanation;
  }
  if (selection.shortest_tether) json["shortest_tether"] = values.Of(*selection.shortest_tether, "path");
  if (const auto& reference = selection.reference) {
    json["path"] = values.Of(reference->path);
    json["length"] = reference->length_m;
    json["word"] = values.Of(reference->word);
    json["tether"]["word"] = values.Of(reference->tether_word);
    json["tether"]["length"] = reference->tether_length_m;
    json["tether"]["limit"] = limit;
  }
  json["classes"] = Json::array();
  for (const ReferenceCandidate& candidate : selection.candidates) json["classes"].push_back(ToJson(values, candidate));
}

Json ToJson(const JsonValues& values, const TrackedPath& tracked) {
  Json json;
  json["method"] = tracked.method;
  if (!tracked.path) return json;
  json["path"] = values.Of(*tracked.path);
  json["length"] = Length(*tracked.path);
  const TrackResult& track = tracked.track;
  json["success"] = track.success();
  json["end"] = ToString(track.end);
  json["driven"] = track.driven_m;
  json["time"] = track.time_s;
  json["cable_obstacle_per_minute"] = track.PerMinute(track.cable_obstacle_steps);
  json["cable_robot_per_minute"] = track.PerMinute(track.cable_robot_steps);
  return json;
}

/// Answers one question, part by part.
class ReferenceAsker {
 public:
  ReferenceAsker(const Scene& scene, const ReferenceQuestion& question, const TetherTask& task, ReferenceAnswer& answer)
      : scene_(scene),
        question_(question),
        task_(task),
        reference_task_{task.laid, task.cable_length_m, task.goal},
        answer_(answer) {}

  Expected<void> Run() {
    if (!Watch("classes", 0)) return tl::unexpected(StoppedError());
    const Clock clock;
    answer_.exact = SelectReference(
        answer_.ground, reference_task_,
        {.list = question_.count, .budget = question_.budget, .keep_going = [this] { return Watch("classes", 0); }});
    answer_.times.exact = clock.ms();
    answer_.status = answer_.exact.reference ? kExitSolved : kExitInfeasible;
    if (question_.yen) {
      if (auto done = RunYen(); !done) return done;
    }
    if (question_.baselines && answer_.exact.reference) return Track();
    return {};
  }

 private:
  bool Watch(const char* stage, double share) const { return !question_.watch || question_.watch(stage, share); }

  static Error StoppedError() { return {ErrorCode::kStopped, "stopped before the reference was chosen", ""}; }

  Expected<void> RunYen() {
    const Clock clock;
    try {
      auto yen = SelectReferenceByYen(answer_.ground, reference_task_,
                                      {.count = question_.paths, .step_m = answer_.step_m, .keep_going = [this] {
                                         return Watch("paths of the lattice", 0);
                                       }});
      if (!yen) return InvalidInput(yen.error().message, "--step");
      answer_.yen = *std::move(yen);
    } catch (const Stopped&) {
      return tl::unexpected(StoppedError());
    }
    answer_.times.yen = clock.ms();
    return {};
  }

  Expected<void> Track() {
    const ClassPathQuery query{task_.laid.back(), task_.goal, answer_.exact.reference->word};
    answer_.tracked.push_back({"reference", answer_.exact.reference->path, {}});
    Watch("lattice", 0);
    answer_.tracked.push_back({"dijkstra", HomotopicDijkstra(answer_.ground, query, {.step_m = answer_.step_m}), {}});
    Watch("Voronoi diagram", 0);
    answer_.tracked.push_back({"voronoi", HomotopicVoronoi(answer_.ground, query), {}});
    const ContactMap map(answer_.ground.ungrown_space(), answer_.robot_radius_m / 4);
    for (TrackedPath& tracked : answer_.tracked) {
      if (!tracked.path) continue;
      TetherTask task = task_;
      task.waypoints = Waypoints(*tracked.path, answer_.robot_radius_m);
      TetherEnvOptions options = OptionsFor(scene_);
      options.robot_radius_m = answer_.robot_radius_m;
      options.link_length_m = 2 * answer_.robot_radius_m;
      options.goal_radius_m = answer_.robot_radius_m;
      // Ten times as long as it takes without a turn, and a minute.
      options.max_steps = 600 + static_cast<int>(std::min(1e9, 100 * Length(*tracked.path)));
      auto env = TetherEnv::Create(map, task, options);
      if (!env) return InvalidInput(env.error().message, "--baselines");
      tracked.track = TrackPath(*std::move(env), *tracked.path, {.lookahead_m = question_.lookahead_m});
    }
    return {};
  }

  const Scene& scene_;
  const ReferenceQuestion& question_;
  const TetherTask& task_;
  ReferenceTask reference_task_;
  ReferenceAnswer& answer_;
};

void WriteJson(const ReferenceQuestion& question, const Tether& tether, ReferenceAnswer& answer) {
  const JsonValues values(answer.ground.space().free_space());
  Json& json = answer.json;
  json["command"] = "learn reference";
  AddSelection(values, answer.exact, tether.length, json);
  json["complete"] = answer.exact.all_listed;
  json["robot_radius"] = answer.robot_radius_m;
  if (answer.yen) {
    Json& yen = json["yen"];
    AddSelection(values, *answer.yen, tether.length, yen);
    yen["paths"] = question.paths;
    yen["step"] = answer.step_m;
  }
  if (question.baselines) json["tracked"] = Json::array();
  for (const TrackedPath& tracked : answer.tracked) json["tracked"].push_back(ToJson(values, tracked));
  if (!question.time) return;
  json["milliseconds"] = {{"ground", answer.times.ground}, {"exact", answer.times.exact}};
  if (answer.yen) json["milliseconds"]["yen"] = answer.times.yen;
}

/// Every listed path and tether is taut and free.
std::vector<std::string> Faults(const ReferenceAnswer& answer, int& curves) {
  const TautSpace& space = answer.ground.space();
  std::vector<std::string> faults;
  const auto check = [&](const TautPath& path) {
    const bool in_socket = !space.Locate(path.points.front());
    const FreeSpace* stub_space = in_socket ? &answer.ground.ungrown_space() : nullptr;
    for (const std::string& fault : CurveFaults(space.free_space(), path, stub_space)) {
      faults.push_back("a listed curve " + fault);
    }
    ++curves;
  };
  for (const ReferenceCandidate& candidate : answer.exact.candidates) {
    check(candidate.path);
    check(*candidate.tether);
  }
  if (const auto& reference = answer.exact.reference) {
    check({reference->path, reference->length_m, reference->word});
    if (reference->tether_length_m > answer.json["tether"]["limit"].get<double>() * (1 + kLengthTolerance)) {
      faults.emplace_back("the tether of the reference is too long");
    }
  }
  return faults;
}

}  // namespace

Expected<ReferenceAnswer> AnswerReference(const Scene& scene, const ReferenceQuestion& question) {
  const auto task = TaskOf(scene);
  if (!task) return tl::unexpected(task.error());
  const double radius = question.robot_radius_m.value_or(scene.robot.radius.value_or(kUsualRadius));
  if (!(radius > 0)) return InvalidInput("the robot's radius must be larger than 0", "--robot-radius");
  const Clock clock;
  auto ground = PrepareRobotGround(scene.world, radius, question.watch);
  if (!ground) return tl::unexpected(ground.error());
  ReferenceAnswer answer{
      .ground = *std::move(ground), .robot_radius_m = radius, .step_m = question.step_m.value_or(radius)};
  answer.times.ground = clock.ms();
  if (question.yen || question.baselines) {
    const auto step = CheckLatticeStep(answer.ground.space(), answer.step_m);
    if (!step) return InvalidInput(step.error().message, "--step");
  }
  if (auto done = ReferenceAsker(scene, question, *task, answer).Run(); !done) return tl::unexpected(done.error());
  WriteJson(question, *scene.tether, answer);
  if (MustVerify(question.verify)) {
    int curves = 0;
    const std::vector<std::string> faults = Faults(answer, curves);
    answer.verified_curves = ReportVerification(faults, curves, answer.json);
  }
  return answer;
}

}  // namespace tautline
