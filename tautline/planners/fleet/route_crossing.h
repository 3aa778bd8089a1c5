// Where two cable lines cross: the corrected intersection tests, on nodes instead of on angles.
#ifndef TAUTLINE_PLANNERS_FLEET_ROUTE_CROSSING_H_
#define TAUTLINE_PLANNERS_FLEET_ROUTE_CROSSING_H_

#include <string>
#include <vector>

#include "tautline/planners/fleet/layout.h"

namespace tautline {

/// How two routes cross. In brackets, the case of [Zhang2019, App. B], which are those of [Hert1997].
enum class CrossingKind {
  kInterior,         ///< Two edges cross between their nodes.
  kEndOutsideBend,   ///< [1a] One route ends at a node that the other bends around, and comes there from outside.
  kEndOfShared,      ///< [1b] They share edges, at an end of which one of them ends, and lie in different order there.
  kThroughNode,      ///< [2a] Both pass a node and share no edge there: one comes and leaves on two sides of the other.
  kBendAgainstBend,  ///< [2a] Likewise, but both bend away from each other, each with the node on the far side.
  kSharedPart,       ///< [2b] They share edges, and come to them on one side of each other and leave on the other.
};

/// "interior", "end_outside_bend", "end_of_shared", "through_node", "bend_against_bend", "shared_part".
std::string ToString(CrossingKind kind);

/// Two routes cross.
struct RouteCrossing {
  CrossingKind kind = CrossingKind::kInterior;  ///< How.
  /// Where, metres: the point, the node, or the end of the shared part that the first route comes to last.
  Point at;
  /// The nodes that both pass there, in the order of the first route; empty for kInterior, one where no edge is shared.
  std::vector<FleetNodeId> shared;
};

/// Every crossing of two routes: those at nodes, then the others, both in the order of the first route. None means that
/// the two lines can be moved apart by as little as one likes, each with every node at which it bends still on its
/// inner side; a node that a route passes straight and without a side may be on either. A part that both share, in one
/// direction or in opposite ones, counts at most once. Exact. Requires routes of one ground, none of which turns
/// straight back. O(n log n) for n steps and edges that do not run through each other's boxes. [Zhang2019, App. B]
std::vector<RouteCrossing> RouteCrossings(const FleetGround& ground, const Route& a, const Route& b);

/// Whether there is any crossing, without saying which. As RouteCrossings, and ends at the first one.
bool RoutesCross(const FleetGround& ground, const Route& a, const Route& b);

/// Only the crossings at nodes that both pass: all but kInterior. O(n log n).
std::vector<RouteCrossing> NodeCrossings(const FleetGround& ground, const Route& a, const Route& b);

/// Where two segments that cross between their ends cross, metres, rounded.
Point CrossingPoint(Point a, Point b, Point c, Point d);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_ROUTE_CROSSING_H_
