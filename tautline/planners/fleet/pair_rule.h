// Who must pass first where paths cross [Zhang2019, Sec. 4.2].
#ifndef TAUTLINE_PLANNERS_FLEET_PAIR_RULE_H_
#define TAUTLINE_PLANNERS_FLEET_PAIR_RULE_H_

#include <vector>

#include "tautline/planners/fleet/path_crossings.h"

namespace tautline {

/// A contact of two paths with an order.
struct OrderedContact {
  PathContact contact;   ///< Where they meet, and how.
  bool a_first = false;  ///< Whether a must pass it before b.

  /// The robot that passes first.
  RobotId first() const { return a_first ? contact.a : contact.b; }
  /// The robot that passes then.
  RobotId second() const { return a_first ? contact.b : contact.a; }
  /// What the first one does there.
  const PathVisit& of_first() const { return a_first ? contact.of_a : contact.of_b; }
  /// What the second one does there.
  const PathVisit& of_second() const { return a_first ? contact.of_b : contact.of_a; }
  /// Whether the second robot only comes to its target on the path of the first.
  bool is_touch() const { return !contact.crosses(); }
};

/// Two robots for which the pair rule does not hold, since the layout breaks an assumption of it.
struct AssumptionFault {
  RobotId a;                  ///< Whose cable polygon.
  RobotId b;                  ///< Whose start or path.
  bool start_inside = false;  ///< The start of b is on the path of a or inside of its cable polygon; otherwise
                              ///< the paths cross and not exactly one of both targets is inside.
  Point at;                   ///< That start, or the crossing.
};

/// How pairs of robots on their shortest paths interact.
struct PairInteractions {
  std::vector<OrderedContact> orders;   ///< By a, b and the way along a.
  std::vector<PairDeadlock> deadlocks;  ///< By a and b.
  std::vector<AssumptionFault> faults;  ///< By a and b.
};

/// What the cable lines demand of the shortest paths. The cable polygon of a robot is the loop along its cable line and
/// back along its shortest path; whether it holds the target of another one is decided by its winding number about the
/// target, shifted infinitesimally to the inner side of the bend where the cable line bends around it. Among obstacles
/// the same holds in the universal cover, for each crossing by itself: the winding number about one lift of the target
/// is a coefficient of the Fox derivative [Fox1953] of the word of the loop. A target that lies on the path of another
/// robot is passed by that one first. Requires the shortest paths of the layout and their contacts. Cost: for each
/// contact, and for each target in the bounding box of a cable polygon, the points of that.
PairInteractions FindInteractions(const FleetGround& ground, const FleetLayout& layout,
                                  const std::vector<RobotPath>& paths, const std::vector<PathContact>& contacts);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_PAIR_RULE_H_
