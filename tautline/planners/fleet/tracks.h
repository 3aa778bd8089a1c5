// Routes side by side: lines that share nodes and edges, drawn a little apart in the order that they have.
#ifndef TAUTLINE_PLANNERS_FLEET_TRACKS_H_
#define TAUTLINE_PLANNERS_FLEET_TRACKS_H_

#include <cstddef>
#include <optional>
#include <vector>

#include "tautline/planners/fleet/layout.h"

namespace tautline {

/// The same routes with a side for every node that they pass straight: that from which they cross neither the route
/// that ends there nor those that bend around it, as far as one side suits all. O(n log n + shared parts) for n steps,
/// expected.
std::vector<Route> WithSides(const FleetGround& ground, const std::vector<Route>& routes);

/// The diagonal of the box around all nodes, metres; far from the origin at least a share of the coordinates, so that
/// tiny shares of the size are well above rounding everywhere. O(nodes).
double SizeOfGround(const FleetGround& ground);

/// A node that lies off a route by no more than rounding, so that tracks cannot be laid between them, or robots that
/// stop on the way may stand on its other side.
struct NearMiss {
  std::size_t route = 0;  ///< Which route, by position.
  FleetNodeId node;       ///< Which node.
};

/// The first one, if any. Where routes turn at the node, or the route turns beside it, there must be room for tracks;
/// elsewhere for the rounding of coordinates only. Cost as SideBySide.
std::optional<NearMiss> FindNearMiss(const FleetGround& ground, const std::vector<Route>& routes);

/// How routes are laid side by side.
struct TrackOptions {
  /// The distance between neighbours, metres. Absent: so small that no track comes near a node that its route does not
  /// pass, so that tracks cross exactly where the routes do.
  std::optional<double> spacing;
};

/// One polyline per route, with one point per step: at each node that it passes with a side, the track keeps off the
/// node to the other side, farther off the more routes lie between it and the node. Routes that do not cross become
/// tracks that do not meet, and routes that cross on a shared part become tracks that cross there once. Starts and
/// targets stay in place. Requires routes of one ground that turn nowhere
/// straight back. O(n log n + shared parts) for n steps, expected.
std::vector<Polyline> SideBySide(const FleetGround& ground, const std::vector<Route>& routes,
                                 const TrackOptions& options = {});

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_TRACKS_H_
