#include "apps/answers/contact_free_answer.h"

#include <utility>

#include "apps/answers/verification.h"
#include "tautline/planners/contact_free/motion_faults.h"

namespace tautline {
namespace {

const char* NameOf(ContactFreeStatus status) {
  switch (status) {
    case ContactFreeStatus::kSolved:
      return "solved";
    case ContactFreeStatus::kInfeasible:
      return "infeasible";
    case ContactFreeStatus::kBudgetExceeded:
      return "budget_exceeded";
  }
  return "";
}

/// Equal velocities that follow one another, as one entry.
Json MotionJson(const DrivenMotion& motion) {
  Json list = Json::array();
  for (std::size_t i = 0, next = 0; i < motion.velocities.size(); i = next) {
    while (next < motion.velocities.size() && motion.velocities[next] == motion.velocities[i]) ++next;
    Json& entry = list.emplace_back();
    entry["speed"] = motion.velocities[i].speed_m_per_s;
    entry["turn"] = motion.velocities[i].turn_rad_per_s;
    entry["steps"] = next - i;
  }
  return list;
}

void AddCosts(const ContactFreeResult& result, double dt_s, Json& json) {
  const MotionCosts& costs = result.motion.costs;
  json["cost"] = result.cost;
  json["bound"] = result.bound;
  json["penalty"] = costs.penalty;
  json["shortest"] = result.shortest_m;
  json["time"] = dt_s * costs.steps;
  json["turning_steps"] = costs.turning_steps;
  json["cable_obstacle_steps"] = costs.cable_obstacle_steps;
  json["cable_robot_steps"] = costs.cable_robot_steps;
  json["cable_obstacle_per_minute"] = costs.PerMinute(costs.cable_obstacle_steps, dt_s);
  json["cable_robot_per_minute"] = costs.PerMinute(costs.cable_robot_steps, dt_s);
  json["fewest_contacts"] = result.contacts_proved();
}

void AddMotion(const Scene& scene, const ContactFreeResult& result, const JsonValues& values, double dt_s, Json& json) {
  const DrivenMotion& motion = result.motion;
  json["path"] = values.Of(motion.Path());
  json["length"] = motion.costs.length_m;
  json["tether"] = values.Of(result.tether, "taut");
  json["tether"]["limit"] = scene.tether->length;
  Json& found = json["contact_free"];
  AddCosts(result, dt_s, found);
  found["expansions"] = result.expansions;
  found["step"] = dt_s;
  found["start_heading"] = motion.poses.front().heading_rad;
  found["heading"] = motion.poses.back().heading_rad;
  found["motion"] = MotionJson(motion);
  // As a scene's laid cable: it ends at the robot's centre.
  Polyline cable = motion.cables.back();
  cable.push_back(motion.poses.back().at);
  found["cable"] = values.Of(cable);
}

}  // namespace

Expected<ContactFreeAnswer> AnswerContactFree(const Scene& scene, const ContactFreeOptions& options, bool verify) {
  auto result = PlanContactFree(scene, options);
  if (!result) return tl::unexpected(result.error());
  const auto space = BuildFreeSpace(scene.world);
  if (!space) return tl::unexpected(space.error());
  ContactFreeAnswer answer{.result = *std::move(result)};
  Json& json = answer.json;
  json["command"] = "plan";
  json["status"] = NameOf(answer.result.status);
  if (answer.result.status == ContactFreeStatus::kSolved) {
    AddMotion(scene, answer.result, JsonValues(*space), options.env.dt_s, json);
  } else {
    json["reason"] = answer.result.reason;
    json["explanation"] = answer.result.explanation;
    answer.status = kExitInfeasible;
  }
  if (MustVerify(verify) && answer.result.status == ContactFreeStatus::kSolved) {
    ReportVerification(MotionFaults(scene, answer.result, options.costs), 1, json);
    answer.verified = true;
  }
  return answer;
}

}  // namespace tautline
