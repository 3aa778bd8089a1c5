// Whether a layout of cables is one that a fleet can make: free of crossings and loops, with all starts outside.
#ifndef TAUTLINE_PLANNERS_FLEET_CHECK_LAYOUT_H_
#define TAUTLINE_PLANNERS_FLEET_CHECK_LAYOUT_H_

#include <string>
#include <vector>

#include "tautline/planners/fleet/route_crossing.h"

namespace tautline {

/// The cable lines of two robots cross.
struct LayoutCrossing {
  RobotId a;               ///< The lower one; the first of the routes.
  RobotId b;               ///< The higher one.
  RouteCrossing crossing;  ///< How and where.
};

/// A cable line comes back to itself [Zhang2019, Assumption 2].
struct SelfLoop {
  RobotId robot;            ///< Whose.
  Point at;                 ///< Where, metres.
  bool node_twice = false;  ///< It passes a node twice; else two edges cross.
};

/// A robot starts where another one's cable polygon is [Zhang2019, Assumption 1]: the polygon of a cable line and the
/// robot's shortest path, which is straight where there are no obstacles, and else the cable line pulled taut with the
/// other robots removed.
struct EnclosedStart {
  RobotId robot;             ///< Who starts there.
  RobotId by;                ///< Whose polygon it is.
  bool on_boundary = false;  ///< On the cable line or the path itself; else inside, that is, they wind around it.
};

/// A cable is shorter than its cable line.
struct ShortTether {
  RobotId robot;      ///< Whose.
  double length = 0;  ///< Of the cable line, metres.
  double limit = 0;   ///< Of the cable, metres.
};

/// All that is wrong with a layout, each list in the order of the robots.
struct LayoutFaults {
  std::vector<LayoutCrossing> crossings;       ///< By both robots.
  std::vector<SelfLoop> self_loops;            ///< Places where cable lines come back to themselves.
  std::vector<EnclosedStart> starts_enclosed;  ///< By the owner of the polygon.
  std::vector<ShortTether> short_tethers;      ///< Cables that do not suffice.
  bool all_crossings = true;                   ///< Whether `crossings` was not cut short.

  /// Whether nothing is wrong.
  bool none() const {
    return crossings.empty() && self_loops.empty() && starts_enclosed.empty() && short_tethers.empty();
  }
};

/// How a layout is checked.
struct CheckLayoutOptions {
  std::size_t max_crossings = 100'000;  ///< After about so many the search for more ends.
  Watcher watch;                        ///< Told how far the check has come.
};

/// Checks all robots of a layout and all pairs of them. Requires a layout of the ground. Throws Stopped when the
/// watcher says stop. Only pairs whose lines come near each other or share a node are compared: O(n log n) for n steps
/// of routes that stay in their neighbourhood.
LayoutFaults CheckLayout(const FleetGround& ground, const FleetLayout& layout, const CheckLayoutOptions& options = {});

/// The self loops of one route. Requires that it does not turn straight back.
std::vector<SelfLoop> SelfLoops(const FleetGround& ground, RobotId robot, const Route& route);

/// The starts of other robots that the polygon of one route encloses.
std::vector<EnclosedStart> EnclosedStarts(const FleetGround& ground, RobotId robot, const Route& route);

/// One sentence without a full stop that says what is wrong.
std::string Explain(const FleetGround& ground, const LayoutCrossing& fault);
/// Likewise.
std::string Explain(const FleetGround& ground, const SelfLoop& fault);
/// Likewise.
std::string Explain(const FleetGround& ground, const EnclosedStart& fault);
/// Likewise.
std::string Explain(const FleetGround& ground, const ShortTether& fault);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_CHECK_LAYOUT_H_
