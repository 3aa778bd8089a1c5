// When robots are where: the earliest times that keep all orders.
#ifndef TAUTLINE_PLANNERS_FLEET_SCHEDULE_H_
#define TAUTLINE_PLANNERS_FLEET_SCHEDULE_H_

#include <optional>
#include <vector>

#include "tautline/planners/fleet/event_graph.h"

namespace tautline {

/// The earliest motion of all robots at once: each drives at its speed and waits at an event until everything has
/// happened that must come before it; at one time will do. Nothing where the events wait for each other in a circle.
/// Paths by RobotId, the chains of `graph` theirs. O((events + edges) log events).
std::optional<std::vector<RobotSchedule>> EarliestSchedule(const FleetGround& ground,
                                                           const std::vector<RobotPath>& paths,
                                                           const EventGraph& graph);

/// The motion of one robot after the other, in this order. O(events).
std::vector<RobotSchedule> SequentialSchedule(const FleetGround& ground, const std::vector<RobotPath>& paths,
                                              const EventGraph& graph, const std::vector<RobotId>& order);

/// Drives slower instead of waiting: each robot leaves each event when it did before, and comes there just then. Where
/// it waited at its start, it does still. O(events).
void SlowDownInsteadOfWaiting(std::vector<RobotSchedule>& schedule);

/// When the last robot arrives, s, and how far all drive, metres.
TravelCost CostOf(const std::vector<RobotSchedule>& schedule);

/// How near two robots come to each other, metres; after its arrival a robot stays at its target. Exact up to rounding.
/// O(events of both).
double LeastDistance(const RobotSchedule& a, const RobotSchedule& b);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_SCHEDULE_H_
