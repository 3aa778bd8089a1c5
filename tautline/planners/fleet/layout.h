// Cable layouts: the target cable line of every robot, as nodes that it passes.
#ifndef TAUTLINE_PLANNERS_FLEET_LAYOUT_H_
#define TAUTLINE_PLANNERS_FLEET_LAYOUT_H_

#include <string>
#include <vector>

#include "tautline/planners/fleet/fleet_ground.h"

namespace tautline {

/// A node that a route passes.
struct RouteStep {
  FleetNodeId node;  ///< Which.
  /// The side of a traveller along the route on which the node lies, infinitely near: that which the route turns to at
  /// a bend, and that of the obstacle where it grazes a corner. kNone at the two ends, and where the route leads
  /// straight over a start or a target, which it may then pass on either side.
  Side side = Side::kNone;

  /// Whether both are equal.
  friend bool operator==(const RouteStep&, const RouteStep&) = default;
};

/// A taut line as nodes: every node on it, also those that it passes without a bend, in order.
using Route = std::vector<RouteStep>;

/// The target cable line of each robot, from its start to its target, by RobotId. Bends turn around the node by less
/// than a half turn; at a corner, around the obstacle.
using FleetLayout = std::vector<Route>;

/// What keeps a polyline from being a cable line.
enum class CableLineObstruction {
  kBlocked,      ///< It leaves the free space, or ends outside of it.
  kBendsInOpen,  ///< It bends where there is neither another robot's target or start nor a corner.
  kNotTaut,      ///< It bends at a corner, but not around the obstacle, or it turns straight back.
};

/// A cable line that cannot be one.
struct CableLineFault {
  CableLineObstruction obstruction = CableLineObstruction::kBlocked;  ///< What is wrong.
  RobotId robot;                                                      ///< Whose.
  Point at;                                                           ///< Where, metres.
};

/// One sentence without a full stop that says what is wrong and how to mend it.
std::string Explain(const FleetGround& ground, const CableLineFault& fault);

/// A polyline as a route: its inner points are moved onto the nodes that they name. Requires at least two points that
/// are the start and the target of the robot. O(1) expected for each node.
tl::expected<Route, CableLineFault> ReadRoute(const FleetGround& ground, RobotId robot, std::span<const Point> line);

/// The cable lines of all robots. Requires that every robot has one.
tl::expected<FleetLayout, CableLineFault> ReadLayout(const FleetGround& ground);

/// The points of a route.
Polyline PointsOf(const FleetGround& ground, const Route& route);

/// The length of a route, metres.
double LengthOf(const FleetGround& ground, const Route& route);

/// The same route without the nodes that it passes straight: two routes are of one class when these are equal.
Route BendsOf(const FleetGround& ground, const Route& route);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_LAYOUT_H_
