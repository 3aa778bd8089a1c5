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
