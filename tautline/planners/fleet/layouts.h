// All layouts of cables that a fleet can make, for given starts and targets, the shortest first.
#ifndef TAUTLINE_PLANNERS_FLEET_LAYOUTS_H_
#define TAUTLINE_PLANNERS_FLEET_LAYOUTS_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "tautline/planners/fleet/layout.h"

namespace tautline {

/// Which layouts are wanted, and how hard they are searched for.
struct LayoutsOptions {
  std::optional<double> max_length;  ///< Of each cable line, metres; besides, none is longer than the robot's cable.
  std::optional<double> max_total;   ///< Of all cable lines together, metres.
  std::size_t max_count = 100;       ///< Only so many, the shortest.
  bool count_all = false;            ///< Also count all layouts up to the limits.
  std::int64_t budget = 20'000'000;  ///< Steps of the search after which it ends.
  Watcher watch = {};                ///< Told how far the search has come; when it says stop, the search ends.
};

/// A layout, found.
struct FoundLayout {
  FleetLayout routes;           ///< By RobotId.
  std::vector<double> lengths;  ///< Of the cable lines by RobotId, metres.
  double total = 0;             ///< Of all cable lines, metres.
};

/// What a search for layouts found.
struct LayoutsResult {
  std::vector<FoundLayout> layouts;    ///< By total length.
  bool complete = false;               ///< Whether no layout up to the limits is missing.
  bool budget_exceeded = false;        ///< Whether the search ended early.
  double complete_below = 0;           ///< No layout with a shorter total is missing, metres; infinite when complete.
  std::optional<std::uint64_t> count;  ///< Of all layouts up to the limits; absent unless all were asked for and found.
  std::vector<RobotId> without_route;  ///< Robots that have no cable line of their own up to the limits.
  std::size_t routes = 0;              ///< Cable lines that were tried, of all robots.
};

/// Finds the layouts that CheckLayout finds nothing wrong with, of cable lines that bend around targets of others and
/// corners, and lead over no start or target without a bend: on which side that would be passed is open. Totals that
/// are equal keep the order of the routes' lengths, robot by robot.
///
/// Cable lines are searched best first up to a length that grows until the layouts asked for are found; all pairs of
/// them are compared once, and layouts are put together depth-first, robot by robot, leaving those that cross or
/// cannot be short enough. Exponential in the robots: eight in the plane take seconds, exhaustively. [Hert1997]
LayoutsResult FindLayouts(const FleetGround& ground, const LayoutsOptions& options = {});

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_LAYOUTS_H_
