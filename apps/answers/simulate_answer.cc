#include "apps/answers/simulate_answer.h"

#include <algorithm>
#include <utility>

#include "apps/answers/fleet_plan_answer.h"
#include "apps/answers/plan_json_reader.h"
#include "tautline/base/check.h"
#include "tautline/planners/fleet/robot_paths.h"
#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

/// Cables are measured a hair's breadth off crossings; so much longer than the tether is no fault.
constexpr double kMeasured = 1e-6;

RobotSchedule DriveFrom(double start, const FleetRobot& robot, RobotPath path) {
  RobotSchedule schedule;
  for (std::size_t k = 0; k < path.points.size(); ++k) {
    FleetEvent event;
    event.kind = k == 0                        ? FleetEventKind::kStart
                 : k + 1 == path.points.size() ? FleetEventKind::kTarget
                                               : FleetEventKind::kBend;
    event.at = path.points[k];
    event.along = path.along[k];
    event.departure = start + path.along[k] / robot.speed;
    event.arrival = k == 0 ? 0 : event.departure;
    schedule.events.push_back(event);
  }
  schedule.path = std::move(path);
  return schedule;
}

/// Robots on their shortest paths, each when the one before has arrived.
Expected<DrivenPlan> InTurns(const FleetSetup& setup, const std::vector<std::string>& order) {
  const FleetGround& ground = setup.ground;
  std::vector<RobotPath> paths = ShortestPaths(ground, **setup.layout);
  DrivenPlan driven;
  driven.schedule.resize(ground.size());
  double t = 0;
  for (const std::string& name : order) {
    const auto found = std::find_if(ground.robots().begin(), ground.robots().end(),
                                    [&](const FleetRobot& robot) { return robot.name == name; });
    if (found == ground.robots().end()) return InvalidInput("there is no robot '" + name + "'", "--order");
    const auto i = static_cast<std::size_t>(found - ground.robots().begin());
    if (!driven.schedule[i].events.empty()) return InvalidInput("'" + name + "' is there twice", "--order");
    driven.schedule[i] = DriveFrom(t, *found, std::move(paths[i]));
    t = driven.schedule[i].events.back().arrival;
  }
  for (std::size_t i = 0; i < ground.size(); ++i) {
    if (!driven.schedule[i].events.empty()) continue;
    return InvalidInput(
        "'" + setup.name(RobotId(i)) + "' is missing: name all robots, in the order in which they drive", "--order");
  }
  // What the orders would have to be; some layouts have none.
  if (const auto plan = PlanFleet(ground, **setup.layout)) driven.passings = plan->passings;
  return driven;
}

void Refuse(const std::string& reason, const std::string& explanation, SimulateAnswer& answer) {
  answer.json["status"] = "infeasible";
  answer.json["reason"] = reason;
  answer.json["explanation"] = answer.explanation = explanation;
  answer.status = kExitInfeasible;
}

Json Names(const FleetSetup& setup, const std::vector<RobotId>& robots) {
  Json names = Json::array();
  for (const RobotId robot : robots) names.push_back(setup.name(robot));
  return names;
}

std::string Listed(const FleetSetup& setup, const std::vector<RobotId>& robots) {
  constexpr std::size_t kMostNamed = 5;
  std::string text;
  for (std::size_t k = 0; k < std::min(robots.size(), kMostNamed); ++k) {
    text += (k > 0 ? ", " : "") + setup.name(robots[k]);
  }
  return robots.size() > kMostNamed ? text + " and " + std::to_string(robots.size() - kMostNamed) + " more" : text;
}

void AddCables(SimulateAnswer& answer) {
  const FleetSetup& setup = answer.setup;
  const Playback& playback = *answer.playback;
  answer.json["final"] = Json::array();
  answer.json["longest_tethers"] = Json::array();
  for (std::size_t i = 0; i < playback.final_routes.size(); ++i) {
    const RobotId robot(i);
    const bool differs = std::binary_search(playback.differing.begin(), playback.differing.end(), robot);
    answer.json["final"].push_back({{"robot", setup.name(robot)},
                                    {"cable", PointsJson(PointsOf(setup.ground, playback.final_routes[i]))},
                                    {"length", LengthOf(setup.ground, playback.final_routes[i])},
                                    {"matches", !differs}});
    Json longest = {{"robot", setup.name(robot)}, {"length", playback.longest[i].length}, {"t", playback.longest[i].t}};
    const auto& tether = setup.ground.robot(robot).tether;
    if (tether) longest["limit"] = *tether;
    answer.json["longest_tethers"].push_back(std::move(longest));
    if (tether && playback.longest[i].length > *tether + kMeasured * (1 + *tether)) answer.too_short.push_back(robot);
  }
}

void AddOrders(SimulateAnswer& answer) {
  const auto& broken = answer.playback->broken;
  answer.json["orders_kept"] = broken.empty();
  answer.json["broken"] = Json::array();
  for (const BrokenOrder& order : broken) {
    answer.json["broken"].push_back(
        {{"robots", {answer.setup.name(order.first), answer.setup.name(order.second)}}, {"at", PointJson(order.at)}});
  }
}

void Conclude(SimulateAnswer& answer) {
  const FleetSetup& setup = answer.setup;
  const Playback& playback = *answer.playback;
  const auto& differing = playback.differing;
  if (!differing.empty()) {
    Refuse("layout_differs",
           differing.size() == 1 ? "the cable of " + setup.name(differing[0]) + " does not come to its cable line"
                                 : "the cables of " + Listed(setup, differing) + " do not come to their cable lines",
           answer);
  } else if (!playback.broken.empty()) {
    const BrokenOrder& order = playback.broken.front();
    Refuse("order_broken",
           setup.name(order.second) + " passes " + ShortText(order.at) + " before " + setup.name(order.first) +
               ", which should be first",
           answer);
  } else if (!answer.too_short.empty()) {
    const RobotId robot = answer.too_short.front();
    Refuse("tether_too_short",
           "the tether of " + setup.name(robot) + " would have to be " +
               Metres(playback.longest[robot.index()].length) + " long and is " +
               Metres(*setup.ground.robot(robot).tether),
           answer);
  }
}

void Perform(const DrivenPlan& driven, const SimulateQuestion& question, SimulateAnswer& answer) {
  answer.schedule = driven.schedule;
  auto played = Play(answer.setup.ground, **answer.setup.layout, driven.schedule, driven.passings,
                     {.frames = question.frames, .watch = question.watch});
  if (!played) {
    const PlaybackCollision& fault = played.error();
    const std::string a = answer.setup.name(fault.a), b = answer.setup.name(fault.b);
    answer.json["matches_target"] = false;
    Refuse("robots_meet",
           (a == b ? a + " meets what its cable cannot pass" : a + " and " + b + " meet") + " at " +
               ShortText(fault.at) + " after " + ShortNumber(fault.t) + " s, and nothing says who goes first",
           answer);
    answer.json["robots"] = {a, b};
    answer.json["at"] = PointJson(fault.at);
    answer.json["t"] = fault.t;
    return;
  }
  answer.playback = *std::move(played);
  const Playback& playback = *answer.playback;
  // Words of a layout that came out tell the same, or one of both witnesses is wrong.
  TAUTLINE_CHECK(playback.words_agree.value_or(true) || !playback.differing.empty());
  answer.json["matches_target"] = playback.differing.empty();
  AddCables(answer);
  AddOrders(answer);
  if (playback.words_agree) answer.json["words_agree"] = *playback.words_agree;
  if (!answer.too_short.empty()) answer.json["tether_too_short"] = Names(answer.setup, answer.too_short);
  Conclude(answer);
}

/// The plan to play; nothing where there is none, and then the answer says why.
Expected<std::optional<DrivenPlan>> PlanOf(const Scene& scene, const SimulateQuestion& question,
                                           SimulateAnswer& answer) {
  if (question.plan || !question.order.empty()) {
    auto driven = question.plan ? ReadDrivenPlan(answer.setup, *question.plan, question.plan_file)
                                : InTurns(answer.setup, question.order);
    if (!driven) return tl::unexpected(driven.error());
    return *std::move(driven);
  }
  FleetPlanQuestion planning;
  planning.options.mode = question.mode;
  planning.options.watch = question.watch;
  const auto planned = AnswerFleetPlan(scene, planning);
  if (!planned) return tl::unexpected(planned.error());
  answer.json["mode"] = ToString(question.mode);
  if (!planned->plan) {
    answer.json.update(planned->json);
    answer.json["command"] = "fleet simulate";
    answer.explanation = planned->explanation;
    answer.status = kExitInfeasible;
    return std::optional<DrivenPlan>();
  }
  return DrivenPlan{planned->plan->schedule, PassingsToKeep(*planned->plan)};
}

}  // namespace

Expected<SimulateAnswer> AnswerSimulate(const Scene& scene, const SimulateQuestion& question) {
  auto setup = SetUpFleetLayout(scene, question.watch);
  if (!setup) return tl::unexpected(setup.error());
  SimulateAnswer answer{.setup = *std::move(setup)};
  answer.json["command"] = "fleet simulate";
  answer.json["status"] = "solved";
  if (!*answer.setup.layout) {
    AddCableLineFault(answer.setup, answer.setup.layout->error(), answer.json);
    answer.explanation = answer.json["explanation"];
    answer.status = kExitInfeasible;
    return answer;
  }
  try {
    const auto driven = PlanOf(scene, question, answer);
    if (!driven) return tl::unexpected(driven.error());
    if (*driven) Perform(**driven, question, answer);
  } catch (const Stopped&) {
    return tl::unexpected(Error{ErrorCode::kStopped, "stopped before the playback was over", ""});
  }
  return answer;
}

}  // namespace tautline
