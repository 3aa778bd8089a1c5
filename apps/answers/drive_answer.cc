#include "apps/answers/drive_answer.h"

#include <optional>
#include <span>
#include <utility>

#include "apps/answers/manifold_faults.h"
#include "tautline/scene/check_tether.h"
#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

/// Cells of a world that has none.
constexpr double kUsualCell = 0.1;
/// As many as a cable may have.
constexpr double kMostLinks = 1e6;
/// Steps of the simulation from one cell to the next: with more of them, no drive would come to its end.
constexpr double kMostStepsPerCell = 1e4;

const char* NameOf(DriveController controller) {
  switch (controller) {
    case DriveController::kBasic:
      return "basic";
    case DriveController::kExtended:
      return "extended";
    case DriveController::kRetract:
      return "retract";
  }
  return "";
}

const char* ReasonOf(DriveFailure failure) {
  switch (failure) {
    case DriveFailure::kNone:
      return "";
    case DriveFailure::kGoalBlocked:
      return "goal_blocked";
    case DriveFailure::kTetherTooShort:
      return "tether_too_short";
    case DriveFailure::kWayNotFound:
      return "way_not_found";
    case DriveFailure::kNoWay:
      return "no_way";
    case DriveFailure::kTimeUp:
      return "time_limit";
    case DriveFailure::kNotTried:
      return "not_tried";
  }
  return "";
}

/// Why no way was found that keeps off the cable.
std::string ExplainNoWay(const std::string& which, const GoalOutcome& goal, const DriveQuestion& question) {
  if (question.options.controller == DriveController::kBasic) return "the cable holds the robot before " + which;
  if (question.options.controller == DriveController::kRetract) {
    return "the cable blocks every way to " + which + ", from the base as well: try --controller extended";
  }
  return "the cable blocks every way to " + which + ", and " + std::to_string(goal.trials) +
         " simulated motions did not clear one" +
         (question.options.untangle == Untangling::kHeuristic ? ": try --untangle both" : ": raise --search-trials");
}

std::string Explain(const GoalOutcome& goal, std::size_t number, const DriveQuestion& question) {
  const std::string which = "goal " + std::to_string(number) + " at " + ShortText(goal.goal);
  switch (goal.failure) {
    case DriveFailure::kGoalBlocked:
      return which + " lies outside of the map, or in a cell that an obstacle or a wall reaches into";
    case DriveFailure::kTetherTooShort:
      return "the tether does not reach " + which + " along the cells";
    case DriveFailure::kWayNotFound:
      return ExplainNoWay(which, goal, question);
    case DriveFailure::kNoWay:
      return "the cable blocks every way to " + which + ", and no motion of this resolution" +
             (number == 1 ? "" : " from where the robot then is") + " clears one (" + std::to_string(goal.trials) +
             " were simulated)";
    case DriveFailure::kTimeUp:
      return which + " was not visited within " + ShortNumber(question.options.robot.time_limit_s) +
             " s: raise --time-limit";
    default:
      return "";
  }
}

Json ToJson(const JsonValues& values, const GoalOutcome& goal) {
  Json json;
  json["goal"] = values.Of(goal.goal);
  json["reached"] = goal.failure == DriveFailure::kNone;
  if (goal.failure != DriveFailure::kNone) json["reason"] = ReasonOf(goal.failure);
  if (goal.failure != DriveFailure::kNotTried) json["time"] = goal.time_s;
  json["untanglings"] = goal.targets;
  json["trials"] = goal.trials;
  if (goal.searched) json["searched"] = true;
  if (goal.thought_again) json["thought_again"] = true;
  if (!goal.retreat_kept) json["retreat_kept"] = false;
  if (goal.deadlocks_entered) json["deadlocks_entered"] = true;
  return json;
}

Json ToJson(const JsonValues& values, const Contact& contact) {
  Json json;
  json["kind"] = contact.kind == ContactKind::kRobot ? "cable-robot" : "cable-obstacle";
  json["t"] = contact.time_s;
  json["at"] = values.Of(contact.at);
  return json;
}

Json ToJson(const JsonValues& values, const TargetTrials& trials) {
  Json json;
  json["goal"] = values.Of(trials.goal);
  json["robot"] = values.Of(trials.robot);
  json["open"] = trials.open;
  json["accessible"] = trials.region.size();
  if (trials.chosen) json["chosen"] = *trials.chosen;
  json["targets"] = Json::array();
  for (const TriedTarget& target : trials.targets) {
    Json& item = json["targets"].emplace_back();
    item["at"] = values.Of(target.at);
    item["score"] = target.score_m;
    item["clears"] = target.clears;
    item["touches_cable"] = target.touched;
    item["accessible"] = target.region.size();
  }
  return json;
}

std::vector<Point> GoalsOf(const Scene& scene, const DriveQuestion& question) {
  if (!question.goals.empty()) return question.goals;
  std::vector<Point> goals = scene.tasks;
  if (scene.goal) goals.push_back(*scene.goal);
  return goals;
}

/// Starts and drives, once there is a manifold.
class Driving {
 public:
  Driving(const Scene& scene, const DriveQuestion& question, const TautSpace& space, DriveAnswer& answer)
      : scene_(scene), question_(question), space_(space), values_(space.free_space()), answer_(answer) {}

  void Run(const GridManifold& manifold, const std::vector<Point>& goals) {
    const auto start = StartDrive(manifold, space_, *scene_.tether, question_.options);
    if (!start) return Refuse("infeasible", start.error().reason, start.error().explanation);
    DriveOptions options = question_.options;
    const auto watch = question_.watch;
    options.on_goal = [&](std::size_t done) {
      if (watch) watch("drive", static_cast<double>(done) / static_cast<double>(goals.size()));
    };
    if (question_.prevent_deadlocks && options.controller == DriveController::kExtended) {
      if (watch) watch("deadlocks", 0);
      const DeadlockAreas areas(manifold, options.robot.keep_going);
      closed_vertices_ = areas.closed_vertices();
      options.deadlocks = ClosedBy(manifold, areas);
    }
    const DriveResult result = Drive(manifold, *start, goals, options);
    answer_.trace = TraceDrive(manifold, *start, result, options.robot, {.sample_s = question_.sample_s});
    AddResult(manifold, result);
    if (question_.candidates > 0) AddCandidates(manifold, *start, result);
  }

  void Refuse(const char* status, const std::string& reason, const std::string& explanation) {
    answer_.explanation = explanation;
    answer_.status = kExitInfeasible;
    answer_.json["status"] = status;
    answer_.json["reason"] = reason;
    answer_.json["explanation"] = explanation;
    answer_.json["success"] = false;
  }

 private:
  /// What untangling weighs where the robot sets out for a goal.
  void AddCandidates(const GridManifold& manifold, const DriveState& start, const DriveResult& result) {
    const std::size_t goal = question_.candidates - 1;
    const DriveFailure failure = result.goals[goal].failure;
    if (failure == DriveFailure::kNotTried || failure == DriveFailure::kGoalBlocked ||
        failure == DriveFailure::kTetherTooShort) {
      return;
    }
    const std::size_t steps = goal == 0 ? 0 : result.goals[goal - 1].steps;
    const DriveState before = Replay(manifold, start, std::span(result.end.way).first(steps), question_.options.robot);
    answer_.candidates = TryTargets(manifold, before, result.goals[goal].goal, question_.options);
    answer_.grid = manifold.ground().grid();
    answer_.json["candidates"] = ToJson(values_, *answer_.candidates);
  }

  void AddResult(const GridManifold& manifold, const DriveResult& result) {
    answer_.json["status"] = "solved";
    answer_.json["success"] = true;
    for (std::size_t i = 0; i < result.goals.size(); ++i) {
      const DriveFailure failure = result.goals[i].failure;
      if (failure == DriveFailure::kNone) continue;
      // Only what a finite search has shown is infeasible: with other visits before it, a goal may have a way.
      const bool proved = failure == DriveFailure::kGoalBlocked || failure == DriveFailure::kTetherTooShort ||
                          (failure == DriveFailure::kNoWay && i == 0);
      Refuse(proved ? "infeasible" : "budget_exceeded", ReasonOf(failure), Explain(result.goals[i], i + 1, question_));
      break;
    }
    answer_.goals = result.goals;
    const auto contacts = result.end.cable.contacts();
    answer_.contacts.assign(contacts.begin(), contacts.end());
    answer_.time_s = result.end.cable.time_s();
    answer_.driven_m = answer_.time_s * question_.options.robot.speed_mps;
    Json& json = answer_.json;
    json["controller"] = NameOf(question_.options.controller);
    json["time"] = answer_.time_s;
    json["distance"] = answer_.driven_m;
    json["cable_robot_contacts"] = result.RobotContacts();
    json["cable_obstacle_contacts"] = contacts.size() - result.RobotContacts();
    json["resolution"] = manifold.ground().cell_m();
    json["vertices"] = manifold.Count().vertices;
    if (closed_vertices_) json["deadlock_vertices"] = *closed_vertices_;
    json["goals"] = Json::array();
    for (const GoalOutcome& goal : result.goals) json["goals"].push_back(ToJson(values_, goal));
    json["contacts"] = Json::array();
    for (const Contact& contact : contacts) json["contacts"].push_back(ToJson(values_, contact));
    json["trace"] = Json::array();
    for (const DriveFrame& frame : answer_.trace) {
      Json& sample = json["trace"].emplace_back();
      sample["t"] = frame.t_s;
      sample["robot"] = values_.Of(frame.robot);
      sample["cable"] = values_.Of(frame.cable);
    }
  }

  const Scene& scene_;
  const DriveQuestion& question_;
  const TautSpace& space_;
  JsonValues values_;
  DriveAnswer& answer_;
  std::optional<std::int64_t> closed_vertices_;  ///< Where deadlock areas were looked for.
};

Expected<std::vector<Point>> CheckedGoals(const Scene& scene, const DriveQuestion& question) {
  if (auto tether = RequireTether(scene); !tether) return tl::unexpected(tether.error());
  if (scene.tether->length > kMostLinks * question.options.link_m) {
    return InvalidInput("links of " + FormatNumber(question.options.link_m) + " m are too short: a tether of " +
                        Metres(scene.tether->length) + " has more than 1000000 of them; give a longer --link");
  }
  std::vector<Point> goals = GoalsOf(scene, question);
  if (goals.empty()) {
    return InvalidInput("the scene has no goal; add `goal: [x, y]` or `tasks: [[x, y], ...]`, or give --goals",
                        scene.path);
  }
  if (question.candidates > goals.size()) {
    return InvalidInput("there are " + std::to_string(goals.size()) + " goals, and --candidates asks for number " +
                            std::to_string(question.candidates),
                        scene.path);
  }
  for (const Point goal : goals) {
    if (auto checked = CheckGoal(goal); !checked) return tl::unexpected(checked.error());
  }
  return goals;
}

Expected<void> CheckSteps(const RobotOptions& robot, double cell_m) {
  const double stride_m = robot.speed_mps * robot.dt_s;
  if (cell_m <= kMostStepsPerCell * stride_m) return {};
  return InvalidInput("steps of " + FormatNumber(robot.dt_s) + " s at " + FormatNumber(robot.speed_mps) +
                      " m/s are too short: more than " + ShortNumber(kMostStepsPerCell) + " of them for a cell of " +
                      Metres(cell_m) + "; give a longer --dt or a higher --speed");
}

}  // namespace

Expected<DriveAnswer> AnswerDrive(const Scene& scene, const DriveQuestion& question) {
  const auto goals = CheckedGoals(scene, question);
  if (!goals) return tl::unexpected(goals.error());
  if (question.watch) question.watch("cells", 0);
  MapCellsOptions cells = question.cells;
  if (!cells.resolution_m && !scene.world.cells) cells.resolution_m = kUsualCell;
  auto ground = MakeCellGround(scene.world, cells);
  if (!ground) return tl::unexpected(ground.error());
  if (auto checked = CheckSteps(question.options.robot, ground->cell_m()); !checked) {
    return tl::unexpected(checked.error());
  }
  auto free_space = BuildFreeSpace(scene.world);
  if (!free_space) return tl::unexpected(free_space.error());
  if (question.watch) question.watch("free space", 0);
  const TautSpace space(*std::move(free_space), question.watch);
  DriveAnswer answer;
  answer.json["command"] = "drive";
  Driving driving(scene, question, space, answer);
  const Tether& tether = *scene.tether;
  if (const std::string fault = BaseFault(*ground, tether.base); !fault.empty()) {
    driving.Refuse("infeasible", "start_blocked", fault);
    return answer;
  }
  if (question.watch) question.watch("manifold", 0);
  const ManifoldOptions options{.base = *ground->CellAt(tether.base),
                                .length_m = LengthFromCell(*ground, tether),
                                .connectivity = question.connectivity == 4 ? Connectivity::kFour : Connectivity::kEight,
                                .max_vertices = question.max_vertices,
                                .max_bytes = question.max_bytes};
  const GridManifold manifold = GridManifold::Build(*std::move(ground), options);
  if (const StopText stop = ExplainStop(manifold, options); !stop.what.empty()) {
    driving.Refuse("budget_exceeded", "budget_exceeded", stop.what + ": " + stop.mend);
    return answer;
  }
  driving.Run(manifold, *goals);
  return answer;
}

}  // namespace tautline
