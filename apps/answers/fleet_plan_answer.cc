#include "apps/answers/fleet_plan_answer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tautline/homotopy/taut_path.h"
#include "tautline/planners/fleet/check_layout.h"
#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

constexpr FleetMode kModes[] = {FleetMode::kStraightConcurrent, FleetMode::kStraightSequential,
                                FleetMode::kBentConcurrent, FleetMode::kBentSequential};

const char* ToString(FleetEventKind kind) {
  switch (kind) {
    case FleetEventKind::kStart:
      return "start";
    case FleetEventKind::kBend:
      return "bend";
    case FleetEventKind::kPassing:
      return "passing";
    case FleetEventKind::kEnter:
      return "enter";
    case FleetEventKind::kLeave:
      return "leave";
    case FleetEventKind::kTarget:
      return "target";
  }
  return "";
}

/// A plan as JSON.
class PlanJson {
 public:
  PlanJson(const FleetSetup& setup, const FleetPlan& plan) : setup_(setup), plan_(plan) {}

  void Add(Json& json) const {
    json["mode"] = ToString(plan_.mode);
    AddPairs(json);
    json["event_graph"] = {{"chains", Chains()}, {"edges", Edges()}};
    const ModeSummary& mode = plan_.modes[static_cast<std::size_t>(plan_.mode)];
    json["detours"] = Names(plan_.detours);
    json["detours_optimal"] = mode.detours_optimal;
    json["detours_bound"] = mode.detours_bound;
    json["schedule"] = Schedule();
    json["travel_time"] = plan_.travel_time;
    json["travel_distance"] = plan_.travel_distance;
    AddModes(json);
  }

  /// The labels of the crossings that are passed at an event.
  std::vector<std::string> Labels(const FleetEvent& event) const {
    std::vector<std::string> labels;
    for (const std::size_t k : event.passings) {
      const std::size_t straight = plan_.passings.size();
      labels.push_back(k < straight ? plan_.passings[k].label : plan_.detour_passings[k - straight].label);
    }
    return labels;
  }

  /// How fast a robot comes to an event, m/s; 0 at the start.
  static double SpeedTo(const RobotSchedule& robot, std::size_t e) {
    if (e == 0) return 0;
    const double duration = robot.events[e].arrival - robot.events[e - 1].departure;
    return duration > 0 ? (robot.events[e].along - robot.events[e - 1].along) / duration : 0;
  }

 private:
  Json Names(const std::vector<RobotId>& robots) const {
    Json names = Json::array();
    for (const RobotId robot : robots) names.push_back(setup_.name(robot));
    return names;
  }

  Json Passings(const std::vector<Passing>& passings) const {
    Json list = Json::array();
    for (const Passing& passing : passings) {
      Json& entry = list.emplace_back();
      entry["label"] = passing.label;
      entry["robots"] = {setup_.name(passing.first), setup_.name(passing.second)};
      entry["at"] = PointJson(passing.at);
      entry["distance"] = passing.distance;
    }
    return list;
  }

  void AddPairs(Json& json) const {
    json["pair_graph"] = Json::array();
    std::vector<std::pair<RobotId, RobotId>> pairs;
    for (const Passing& passing : plan_.passings) {
      const auto pair = std::pair(passing.first, passing.second);
      // Those of one pair of robots stand together.
      const auto of_pair = [&](const auto& other) { return other == pair; };
      const auto from = pairs.size() > 2 ? pairs.end() - 2 : pairs.begin();
      if (std::any_of(from, pairs.end(), of_pair)) continue;
      pairs.push_back(pair);
      json["pair_graph"].push_back({setup_.name(pair.first), setup_.name(pair.second)});
    }
    json["passings"] = Passings(plan_.passings);
    json["detour_passings"] = Passings(plan_.detour_passings);
    json["deadlocked_pairs"] = Json::array();
    for (const PairDeadlock& pair : plan_.pair_deadlocks) {
      json["deadlocked_pairs"].push_back({setup_.name(pair.a), setup_.name(pair.b)});
    }
    json["network_deadlocks"] = Json::array();
    for (const auto& robots : plan_.network_deadlocks) json["network_deadlocks"].push_back(Names(robots));
    json["entangled"] = Json::array();
    for (const auto& robots : plan_.entangled) json["entangled"].push_back(Names(robots));
  }

  Json EventJson(const FleetEvent& event) const {
    Json json;
    json["point"] = ToString(event.kind);
    const auto labels = Labels(event);
    if (!labels.empty()) json["passings"] = labels;
    json["at"] = PointJson(event.at);
    json["along"] = event.along;
    return json;
  }

  Json Chains() const {
    Json chains = Json::array();
    for (std::size_t i = 0; i < plan_.schedule.size(); ++i) {
      Json& chain = chains.emplace_back();
      chain["robot"] = setup_.name(RobotId(i));
      chain["events"] = Json::array();
      for (const FleetEvent& event : plan_.schedule[i].events) chain["events"].push_back(EventJson(event));
    }
    return chains;
  }

  Json Edges() const {
    Json edges = Json::array();
    for (const EventEdge& edge : plan_.event_edges) {
      edges.push_back(
          {{setup_.name(edge.before.first), edge.before.second}, {setup_.name(edge.after.first), edge.after.second}});
    }
    return edges;
  }

  Json Schedule() const {
    Json schedule = Json::array();
    for (std::size_t i = 0; i < plan_.schedule.size(); ++i) {
      const RobotSchedule& robot = plan_.schedule[i];
      Json& entry = schedule.emplace_back();
      entry["robot"] = setup_.name(RobotId(i));
      entry["path"] = PointsJson(robot.path.points);
      entry["follows_cable"] = robot.path.is_cable;
      entry["events"] = Json::array();
      for (std::size_t e = 0; e < robot.events.size(); ++e) {
        const FleetEvent& event = robot.events[e];
        Json& line = entry["events"].emplace_back(EventJson(event));
        line["t"] = event.departure;
        if (event.departure > event.arrival) {
          line["arrival"] = event.arrival;
          line["wait"] = event.departure - event.arrival;
        }
        if (e > 0) line["speed"] = SpeedTo(robot, e);
      }
    }
    return schedule;
  }

  void AddModes(Json& json) const {
    for (const FleetMode mode : kModes) {
      const ModeSummary& summary = plan_.modes[static_cast<std::size_t>(mode)];
      json["modes"][ToString(mode)] = summary.realizable;
      Json& details = json["mode_details"][ToString(mode)];
      details["realizable"] = summary.realizable;
      details["detours"] = Names(summary.detours);
      details["travel_time"] = summary.travel_time;
      details["travel_distance"] = summary.travel_distance;
      if (!summary.without_detours) continue;
      details["detours_optimal"] = summary.detours_optimal;
      details["detours_bound"] = summary.detours_bound;
      details["without_detours"] = {{"travel_time", summary.without_detours->time},
                                    {"travel_distance", summary.without_detours->distance}};
    }
  }

  const FleetSetup& setup_;
  const FleetPlan& plan_;
};

void Refuse(const std::string& reason, const std::string& explanation, FleetPlanAnswer& answer) {
  answer.json["status"] = "infeasible";
  answer.json["reason"] = reason;
  answer.json["explanation"] = answer.explanation = explanation;
  answer.status = kExitInfeasible;
}

/// Tells what is wrong with a layout; whether anything is.
bool RefuseLayout(const LayoutFaults& faults, FleetPlanAnswer& answer) {
  const FleetGround& ground = answer.setup.ground;
  const auto robots = [&](std::initializer_list<RobotId> ids) {
    for (const RobotId id : ids) answer.json["robots"].push_back(answer.setup.name(id));
  };
  if (!faults.crossings.empty()) {
    const LayoutCrossing& fault = faults.crossings.front();
    Refuse("layout_crosses", Explain(ground, fault), answer);
    robots({fault.a, fault.b});
  } else if (!faults.self_loops.empty()) {
    const SelfLoop& fault = faults.self_loops.front();
    Refuse("self_loop", Explain(ground, fault), answer);
    robots({fault.robot});
  } else if (!faults.starts_enclosed.empty()) {
    const EnclosedStart& fault = faults.starts_enclosed.front();
    Refuse("start_enclosed", Explain(ground, fault), answer);
    robots({fault.robot, fault.by});
  } else if (!faults.short_tethers.empty()) {
    const ShortTether& fault = faults.short_tethers.front();
    Refuse("tether_too_short", Explain(ground, fault), answer);
    answer.json["robot"] = answer.setup.name(fault.robot);
    answer.json["needed"] = fault.length;
    answer.json["limit"] = fault.limit;
  }
  return !faults.none();
}

void RefusePlan(const FleetPlanFault& fault, FleetPlanAnswer& answer) {
  const bool gap = fault.obstruction == FleetPlanObstruction::kGapTooWide;
  const bool meet = fault.obstruction == FleetPlanObstruction::kRobotsMeet;
  Refuse(gap    ? "gap_too_wide"
         : meet ? "robots_meet"
                : "assumption_violated",
         Explain(answer.setup.ground, fault), answer);
  for (const RobotId robot : fault.robots) answer.json["robots"].push_back(answer.setup.name(robot));
  if (gap) {
    answer.json["gap"] = fault.gap;
    answer.json["largest_gap"] = fault.largest_gap;
  } else {
    answer.json["at"] = PointJson(fault.at);
  }
}

/// The parts of a scene that a fleet's plan depends on, as a scene file has them.
Json SceneJson(const Scene& scene) {
  Json json;
  const World& world = scene.world;
  if (!world.outline.empty()) json["world"]["outline"] = PointsJson(world.outline);
  for (const Obstacle& obstacle : world.obstacles) {
    Json& entry = json["world"]["obstacles"].emplace_back();
    if (!obstacle.name.empty()) entry["name"] = obstacle.name;
    if (obstacle.polygon) entry["polygon"] = PointsJson(obstacle.polygon->outer);
    if (obstacle.circle)
      entry["circle"] = {obstacle.circle->centre.x, obstacle.circle->centre.y, obstacle.circle->radius};
  }
  if (!world.outline.empty() && world.clearance > 0) json["world"]["clearance"] = world.clearance;
  for (const FleetRobot& robot : scene.fleet->robots) {
    Json& entry = json["fleet"]["robots"].emplace_back();
    entry["name"] = robot.name;
    entry["start"] = PointJson(robot.start);
    entry["target"] = PointJson(robot.target);
    if (robot.cable) entry["cable"] = PointsJson(*robot.cable);
    entry["speed"] = robot.speed;
    entry["radius"] = robot.radius;
    if (robot.tether) entry["tether"] = *robot.tether;
  }
  return json;
}

/// Throws FleetPlanContradicted.
[[noreturn]] void Contradict(const Scene& scene, const FleetPlanAnswer& answer, const std::string& what) {
  throw FleetPlanContradicted("the playback of a plan " + what,
                              {{"scene", SceneJson(scene)}, {"plan", answer.json}, {"what", what}});
}

/// Plays the plan, and tells how long the cables must be for it.
void PlayBack(const Scene& scene, const FleetPlanQuestion& question, FleetPlanAnswer& answer) {
  const FleetPlan& plan = *answer.plan;
  PlaybackOptions options = question.playback;
  options.watch = question.options.watch;
  auto played = Play(answer.setup.ground, answer.layout(), plan.schedule, PassingsToKeep(plan), options);
  if (!played) {
    Contradict(scene, answer,
               "has " + answer.setup.name(played.error().a) + " meet " + answer.setup.name(played.error().b) + " at " +
                   ShortText(played.error().at));
  }
  if (!played->differing.empty()) {
    Contradict(scene, answer, "brings about another cable line of " + answer.setup.name(played->differing.front()));
  }
  if (!played->matches()) Contradict(scene, answer, "breaks an order, or its words do not agree");
  answer.json["longest_tethers"] = Json::array();
  for (std::size_t i = 0; i < played->longest.size(); ++i) {
    Json& entry = answer.json["longest_tethers"].emplace_back();
    entry["robot"] = answer.setup.name(RobotId(i));
    entry["length"] = played->longest[i].length;
    entry["t"] = played->longest[i].t;
  }
  answer.played = *std::move(played);
}

/// Refuses a plan for which a cable is too short.
void CheckTethers(FleetPlanAnswer& answer) {
  for (std::size_t i = 0; i < answer.played->longest.size(); ++i) {
    const FleetRobot& robot = answer.setup.ground.robots()[i];
    const LongestTether& longest = answer.played->longest[i];
    if (!robot.tether || longest.length <= *robot.tether * (1 + kLengthTolerance)) continue;
    Json json{{"command", "fleet plan"}};
    std::swap(json, answer.json);
    Refuse("tether_too_short",
           "the cable of " + robot.name + " must be " + Metres(longest.length) + " long at " + ShortNumber(longest.t) +
               " s, and it is " + Metres(*robot.tether) +
               ": give it a longer one, or let the robots drive in another mode",
           answer);
    answer.json["robot"] = robot.name;
    answer.json["needed"] = longest.length;
    answer.json["limit"] = *robot.tether;
    answer.json["t"] = longest.t;
    answer.plan.reset();
    return;
  }
}

/// Chooses a layout for a scene without cable lines; false where there is none.
bool ChooseTheLayout(const FleetPlanQuestion& question, FleetPlanAnswer& answer) {
  answer.chosen = ChooseLayout(answer.setup.ground, {.budget = question.budget, .watch = question.options.watch});
  const ChosenLayout& chosen = *answer.chosen;
  if (chosen.status != ChooseStatus::kSolved) {
    const bool proved = chosen.status == ChooseStatus::kInfeasible;
    Refuse(proved ? "no_layout" : "budget_exceeded", chosen.explanation, answer);
    if (!proved) answer.json["status"] = "budget_exceeded";
    return false;
  }
  answer.setup.layout.emplace(chosen.layout);
  answer.json["layout"] = Json::array();
  for (std::size_t i = 0; i < chosen.layout.size(); ++i) {
    Json& entry = answer.json["layout"].emplace_back();
    entry["robot"] = answer.setup.name(RobotId(i));
    entry["cable"] = PointsJson(PointsOf(answer.setup.ground, BendsOf(answer.setup.ground, chosen.layout[i])));
  }
  answer.json["layout_optimal"] = chosen.optimal;
  answer.json["layout_length"] = chosen.length;
  return true;
}

}  // namespace

Expected<FleetPlanAnswer> AnswerFleetPlan(const Scene& scene, const FleetPlanQuestion& question) {
  const FleetPlanOptions& options = question.options;
  if (options.gap && !(*options.gap >= 0 && std::isfinite(*options.gap))) {
    return InvalidInput("the gap must be a number that is not negative", "--gap");
  }
  auto setup = SetUpFleet(scene, options.watch);
  if (!setup) return tl::unexpected(setup.error());
  FleetPlanAnswer answer{.setup = std::move(*setup)};
  answer.json["command"] = "fleet plan";
  answer.json["status"] = "solved";
  if (!answer.setup.layout && !ChooseTheLayout(question, answer)) return answer;
  if (!*answer.setup.layout) {
    AddCableLineFault(answer.setup, answer.setup.layout->error(), answer.json);
    answer.explanation = answer.json["explanation"];
    answer.status = kExitInfeasible;
    return answer;
  }
  try {
    if (RefuseLayout(CheckLayout(answer.setup.ground, answer.layout(), {.watch = options.watch}), answer)) {
      return answer;
    }
  } catch (const Stopped&) {
    return tl::unexpected(Error{ErrorCode::kStopped, "stopped while the layout was checked", ""});
  }
  auto plan = PlanFleet(answer.setup.ground, answer.layout(), options);
  if (plan) {
    answer.plan = *std::move(plan);
    PlanJson(answer.setup, *answer.plan).Add(answer.json);
    try {
      PlayBack(scene, question, answer);
    } catch (const Stopped&) {
      return tl::unexpected(Error{ErrorCode::kStopped, "stopped while the plan was played back", ""});
    }
    CheckTethers(answer);
  } else if (plan.error().obstruction == FleetPlanObstruction::kStopped) {
    return tl::unexpected(Error{ErrorCode::kStopped, "stopped before there was a plan", ""});
  } else {
    RefusePlan(plan.error(), answer);
  }
  return answer;
}

std::string FleetPlanCsv(const FleetPlanAnswer& answer) {
  const PlanJson values(answer.setup, *answer.plan);
  std::string text = "robot,event,passings,x,y,along,arrival,departure,speed\n";
  for (std::size_t i = 0; i < answer.plan->schedule.size(); ++i) {
    const RobotSchedule& robot = answer.plan->schedule[i];
    std::string name = answer.setup.name(RobotId(i));
    for (std::size_t at = 0; (at = name.find('"', at)) != std::string::npos; at += 2) name.insert(at, 1, '"');
    for (std::size_t e = 0; e < robot.events.size(); ++e) {
      const FleetEvent& event = robot.events[e];
      text += "\"" + name + "\"," + ToString(event.kind) + ",";
      std::string labels;
      for (const std::string& label : values.Labels(event)) labels += (labels.empty() ? "" : " ") + label;
      text += labels;
      for (const double value :
           {event.at.x, event.at.y, event.along, event.arrival, event.departure, PlanJson::SpeedTo(robot, e)}) {
        text += "," + Json(value).dump();
      }
      text += "\n";
    }
  }
  return text;
}

}  // namespace tautline
