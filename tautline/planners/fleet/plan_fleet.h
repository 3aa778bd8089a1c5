// The motion that makes a layout: straight paths in the right order, detours where there is no such order [Zhang2019].
#ifndef TAUTLINE_PLANNERS_FLEET_PLAN_FLEET_H_
#define TAUTLINE_PLANNERS_FLEET_PLAN_FLEET_H_

#include <optional>
#include <string>
#include <vector>

#include "tautline/planners/fleet/detours.h"
#include "tautline/planners/fleet/fleet_plan.h"

namespace tautline {

/// How a motion is planned.
struct FleetPlanOptions {
  FleetMode mode = FleetMode::kStraightConcurrent;  ///< How the robots move.
  bool speeds = false;                              ///< Drive slower instead of waiting.
  /// How far apart two robots stay at a crossing of their paths, metres, where robots drive straight and at once;
  /// absent: the sum of their radii. 0: points.
  std::optional<double> gap;
  DetourOptions detours = {};  ///< How long the least detours are searched for.
  /// Whether motions are played to find robots that are entangled, see PlanFleet. Without it, the layout may turn out
  /// another one where the caller plays the plan.
  bool play = true;
  Watcher watch = {};  ///< Told how far the planning has come.
};

/// Why there is no plan.
enum class FleetPlanObstruction {
  kAssumptionViolated,  ///< The pair rule does not hold: a start in a cable polygon, or both or neither targets inside.
  kGapTooWide,          ///< Points could keep the orders, robots that far apart would wait for each other in a circle.
  kRobotsMeet,          ///< Two would meet where nothing tells who goes first: places that are all but one.
  kStopped,             ///< The watcher said stop.
};

/// There is no plan, and why.
struct FleetPlanFault {
  FleetPlanObstruction obstruction = FleetPlanObstruction::kAssumptionViolated;  ///< What is in the way.
  std::vector<RobotId> robots;  ///< Those concerned; for an assumption, first the one whose polygon or path it is.
  Point at;                     ///< The start, the crossing or the meeting, metres.
  bool start_inside = false;    ///< For an assumption: whether a start is inside.
  double gap = 0;               ///< The widest gap that was asked for, metres, where it is too wide.
  double largest_gap = 0;       ///< The largest one for all pairs that would do, metres, where it is too wide.
};

/// "A", ..., "Z", "AA", ...: what the crossing at a position of a list is called.
std::string CrossingLabel(std::size_t position);

/// One sentence without a full stop that says what is wrong and how to mend it.
std::string Explain(const FleetGround& ground, const FleetPlanFault& fault);

/// Plans the motion to a layout that is free of crossings. That the orders of all pairs can be kept does not mean yet
/// that the layout comes out: three robots can make another one that looks the same to each two of them. So motions are
/// played (Play), and robots found to be entangled so count as one more kind of deadlock. Requires such a layout, see
/// CheckLayout; for others the motion need not bring it about. Robots on a detour go as early as the orders allow
/// [Zhang2019 lets them wait for all others]. Cost: as ShortestPaths, FindContacts, FindInteractions and LeastDetours;
/// for the rest, O(m log m) for m events. Memory: linear in the points of the paths and in the number of crossings.
tl::expected<FleetPlan, FleetPlanFault> PlanFleet(const FleetGround& ground, const FleetLayout& layout,
                                                  const FleetPlanOptions& options = {});

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_PLAN_FLEET_H_
