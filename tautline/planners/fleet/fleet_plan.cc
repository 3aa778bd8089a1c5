#include "tautline/planners/fleet/fleet_plan.h"

#include <algorithm>

namespace tautline {

std::string ToString(FleetMode mode) {
  switch (mode) {
    case FleetMode::kStraightConcurrent:
      return "straight-concurrent";
    case FleetMode::kStraightSequential:
      return "straight-sequential";
    case FleetMode::kBentConcurrent:
      return "bent-concurrent";
    case FleetMode::kBentSequential:
      return "bent-sequential";
  }
  return "";
}

std::optional<FleetMode> FleetModeNamed(std::string_view name) {
  for (const FleetMode mode : {FleetMode::kStraightConcurrent, FleetMode::kStraightSequential,
                               FleetMode::kBentConcurrent, FleetMode::kBentSequential}) {
    if (ToString(mode) == name) return mode;
  }
  return std::nullopt;
}

std::vector<Passing> PassingsToKeep(const FleetPlan& plan) {
  const auto is_straight = [&](RobotId robot) { return !plan.schedule[robot.index()].path.is_cable; };
  std::vector<Passing> passings;
  for (const Passing& passing : plan.passings) {
    if (is_straight(passing.first) && is_straight(passing.second)) passings.push_back(passing);
  }
  passings.insert(passings.end(), plan.detour_passings.begin(), plan.detour_passings.end());
  return passings;
}

Point PositionAt(const RobotSchedule& schedule, double t_s) {
  const auto& events = schedule.events;
  const auto next =
      std::partition_point(events.begin(), events.end(), [&](const FleetEvent& event) { return event.arrival <= t_s; });
  if (next == events.begin()) return events.front().at;
  const FleetEvent& last = *(next - 1);
  if (next == events.end() || t_s <= last.departure) return last.at;
  return Lerp(last.at, next->at, (t_s - last.departure) / (next->arrival - last.departure));
}

}  // namespace tautline
