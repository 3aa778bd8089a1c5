// The coordinated motion of a fleet: what the planner hands out.
#ifndef TAUTLINE_PLANNERS_FLEET_FLEET_PLAN_H_
#define TAUTLINE_PLANNERS_FLEET_FLEET_PLAN_H_

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tautline/planners/fleet/layout.h"

namespace tautline {

/// How the robots of a fleet move [Zhang2019, Sec. 3.3]: straight, that is, along their shortest paths, or bent, that
/// is, along their cable lines; all at once, or one after the other.
enum class FleetMode { kStraightConcurrent, kStraightSequential, kBentConcurrent, kBentSequential };

/// "straight-concurrent" and so on.
std::string ToString(FleetMode mode);

/// The mode of that name; nothing where there is none.
std::optional<FleetMode> FleetModeNamed(std::string_view name);

/// The way that a robot drives.
struct RobotPath {
  /// The nodes that it passes and on which side; start and target first and last. On a straight path, other robots'
  /// targets and starts are not among them.
  Route route;
  Polyline points;            ///< Where these are, metres.
  std::vector<double> along;  ///< How far along the path each is, metres.
  bool is_cable = false;      ///< Whether it is the robot's cable line: a detour in the straight modes.

  /// How long the path is, metres.
  double length() const { return along.back(); }
};

/// Two paths cross: who must pass first. Paths that share a part before they part to the other side cross there as
/// well; then the order holds all along that part, and `at` is where the second robot comes to it.
struct Passing {
  RobotId first;            ///< Must pass first.
  RobotId second;           ///< May pass then.
  Point at;                 ///< Where, metres.
  std::string label;        ///< A, B, ..., Z, AA, ... in the order of the list.
  double first_along = 0;   ///< How far along the first robot's path it leaves the crossing, metres.
  double second_along = 0;  ///< How far along the second robot's path it comes to the crossing, metres.
  double distance = 0;      ///< The least distance of the two robots in the course of the motion, metres.
};

/// Two robots of which both cannot take their straight paths: the target of each is inside of the other's polygon.
struct PairDeadlock {
  RobotId a;  ///< The lower one.
  RobotId b;  ///< The higher one.
};

/// What happens at a point of a path.
enum class FleetEventKind {
  kStart,
  kBend,
  kPassing,
  kEnter,  ///< It comes so near to a crossing that the robot that passes first must have left it.
  kLeave,  ///< It is so far behind a crossing that the robot that passes then may come.
  kTarget,
};

/// A robot is at a point of its path: a vertex of the event graph.
struct FleetEvent {
  FleetEventKind kind = FleetEventKind::kStart;  ///< What happens there.
  Point at;                                      ///< Where, metres.
  double along = 0;                              ///< How far along the path, metres.
  std::vector<std::size_t> passings;             ///< Those that happen there, by position in FleetPlan::passings; from
                                                 ///< there on in FleetPlan::detour_passings.
  double arrival = 0;                            ///< When the robot comes there, s.
  double departure = 0;                          ///< When it goes on, s; later than `arrival` where it waits.
};

/// A robot's motion: straight and with constant speed from each event to the next.
struct RobotSchedule {
  RobotPath path;                  ///< Where it drives.
  std::vector<FleetEvent> events;  ///< In order; the first at the start, the last at the target.
};

/// An edge of the event graph between the chains of two robots: the first event is not later than the second.
struct EventEdge {
  std::pair<RobotId, std::size_t> before;  ///< Robot, and the event's position in its schedule.
  std::pair<RobotId, std::size_t> after;   ///< Likewise.
};

/// How long a motion takes and how far it goes.
struct TravelCost {
  double time = 0;      ///< Until the last robot arrives, s.
  double distance = 0;  ///< Of all robots, metres.
};

/// What one mode of motion costs.
struct ModeSummary {
  bool realizable = false;        ///< Whether the layout comes out with no robot on a detour.
  std::vector<RobotId> detours;   ///< The robots that must follow their cable line; in bent modes empty.
  bool detours_optimal = true;    ///< Whether there are proved to be no fewer, nor shorter ones as few.
  std::size_t detours_bound = 0;  ///< There are no fewer than this.
  /// With detours: what the mode would cost if all robots drove straight and none waited, which does not bring the
  /// layout about.
  std::optional<TravelCost> without_detours;
  double travel_time = 0;      ///< Until the last robot arrives, detours included, s.
  double travel_distance = 0;  ///< Of all robots, metres.
};

/// The motion of all robots in one mode.
struct FleetPlan {
  FleetMode mode = FleetMode::kStraightConcurrent;      ///< The mode of the motion below.
  std::vector<Passing> passings;                        ///< The pair interaction graph of the straight paths.
  std::vector<PairDeadlock> pair_deadlocks;             ///< Its edges in both directions.
  std::vector<std::vector<RobotId>> network_deadlocks;  ///< Robots that wait for each other in a circle, each circle
                                                        ///< once for each strongly connected part of the event graph.
  /// Robots that keep the orders of all pairs on their straight paths and do not make their part of the layout all the
  /// same; those that were met with while detours were sought, each set without any robot that it could do without.
  std::vector<std::vector<RobotId>> entangled;
  std::vector<RobotId> detours;          ///< In this mode, in the order of the robots.
  std::vector<Passing> detour_passings;  ///< Between a robot on a detour and one that is not.
  std::vector<EventEdge> event_edges;    ///< Between chains, of the paths as driven.
  std::vector<RobotSchedule> schedule;   ///< By RobotId.
  double travel_time = 0;                ///< s.
  double travel_distance = 0;            ///< Metres.
  std::array<ModeSummary, 4> modes;      ///< By FleetMode.
};

/// The passings whose order the motion of a plan keeps: those between paths that are driven.
std::vector<Passing> PassingsToKeep(const FleetPlan& plan);

/// Where a robot is at a time, as its schedule says. O(log n) for n events.
Point PositionAt(const RobotSchedule& schedule, double t_s);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_FLEET_PLAN_H_
