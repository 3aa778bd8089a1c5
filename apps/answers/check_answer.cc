#include "apps/answers/check_answer.h"

#include <utility>

namespace tautline {
namespace {

Json CrossingJson(const FleetSetup& setup, const LayoutCrossing& fault) {
  Json json = {{"robots", {setup.name(fault.a), setup.name(fault.b)}},
               {"at", PointJson(fault.crossing.at)},
               {"case", ToString(fault.crossing.kind)}};
  json["shared"] = Json::array();
  for (const FleetNodeId node : fault.crossing.shared) json["shared"].push_back(NodeJson(setup, node));
  return json;
}

void AddCables(const FleetSetup& setup, Json& json) {
  json["cables"] = Json::array();
  double total = 0;
  for (std::size_t i = 0; i < setup.ground.size(); ++i) {
    const double length = LengthOf(setup.ground, (**setup.layout)[i]);
    json["cables"].push_back({{"robot", setup.name(RobotId(i))}, {"length", length}});
    total += length;
  }
  json["length"] = total;
}

void AddFaults(const FleetSetup& setup, const LayoutFaults& faults, Json& json) {
  json["crossing_free"] = faults.crossings.empty();
  json["crossings"] = Json::array();
  for (const LayoutCrossing& fault : faults.crossings) json["crossings"].push_back(CrossingJson(setup, fault));
  if (!faults.all_crossings) json["more_crossings"] = true;
  json["self_loops"] = Json::array();
  for (const SelfLoop& fault : faults.self_loops) {
    json["self_loops"].push_back({{"robot", setup.name(fault.robot)},
                                  {"at", PointJson(fault.at)},
                                  {"case", fault.node_twice ? "node_twice" : "interior"}});
  }
  json["starts_enclosed"] = Json::array();
  for (const EnclosedStart& fault : faults.starts_enclosed) {
    json["starts_enclosed"].push_back({{"robot", setup.name(fault.robot)},
                                       {"by", setup.name(fault.by)},
                                       {"at", PointJson(setup.ground.robot(fault.robot).start)},
                                       {"case", fault.on_boundary ? "boundary" : "interior"}});
  }
  json["tethers_too_short"] = Json::array();
  for (const ShortTether& fault : faults.short_tethers) {
    json["tethers_too_short"].push_back(
        {{"robot", setup.name(fault.robot)}, {"length", fault.length}, {"limit", fault.limit}});
  }
}

const char* ReasonOf(const LayoutFaults& faults) {
  if (!faults.crossings.empty()) return "layout_crosses";
  if (!faults.self_loops.empty()) return "self_loop";
  return !faults.starts_enclosed.empty() ? "start_enclosed" : "tether_too_short";
}

template <class Faults>
void Explain(const FleetGround& ground, const Faults& faults, std::vector<std::string>& explanations) {
  for (const auto& fault : faults) explanations.push_back(tautline::Explain(ground, fault));
}

std::vector<std::string> ExplainAll(const FleetGround& ground, const LayoutFaults& faults) {
  std::vector<std::string> explanations;
  Explain(ground, faults.crossings, explanations);
  Explain(ground, faults.self_loops, explanations);
  Explain(ground, faults.starts_enclosed, explanations);
  Explain(ground, faults.short_tethers, explanations);
  return explanations;
}

void Fill(CheckAnswer& answer, const Watcher& watch) {
  const FleetSetup& setup = answer.setup;
  answer.faults = CheckLayout(setup.ground, **setup.layout, {.watch = watch});
  answer.explanations = ExplainAll(setup.ground, answer.faults);
  if (answer.faults.none()) {
    answer.json["status"] = "solved";
  } else {
    answer.status = kExitInfeasible;
    answer.json["status"] = "infeasible";
    answer.json["reason"] = ReasonOf(answer.faults);
    const std::size_t more = answer.explanations.size() - 1;
    answer.json["explanation"] =
        answer.explanations[0] + (more > 0 ? ", and " + std::to_string(more) + " more" : std::string());
  }
  AddFaults(setup, answer.faults, answer.json);
  AddCables(setup, answer.json);
}

}  // namespace

Expected<CheckAnswer> AnswerCheck(const Scene& scene, const Watcher& watch) {
  auto setup = SetUpFleetLayout(scene, watch);
  if (!setup) return tl::unexpected(setup.error());
  CheckAnswer answer{.setup = *std::move(setup)};
  answer.json["command"] = "fleet check";
  if (!*answer.setup.layout) {
    const CableLineFault& fault = answer.setup.layout->error();
    AddCableLineFault(answer.setup, fault, answer.json);
    answer.explanations = {tautline::Explain(answer.setup.ground, fault)};
    answer.status = kExitInfeasible;
    return answer;
  }
  try {
    Fill(answer, watch);
  } catch (const Stopped&) {
    return tl::unexpected(Error{ErrorCode::kStopped, "stopped while the layout was checked", ""});
  }
  return answer;
}

Json NodeJson(const FleetSetup& setup, FleetNodeId node) {
  Json json = {{"at", PointJson(setup.ground.point(node))}};
  switch (setup.ground.kind(node)) {
    case FleetNodeKind::kStart:
      json["start"] = setup.name(setup.ground.robot_at(node));
      break;
    case FleetNodeKind::kTarget:
      json["target"] = setup.name(setup.ground.robot_at(node));
      break;
    case FleetNodeKind::kCorner:
      json["corner"] = true;
      break;
  }
  return json;
}

}  // namespace tautline
