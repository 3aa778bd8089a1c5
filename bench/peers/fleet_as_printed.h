// A peer: the motion of a fleet by comparing all pairs of robots [Zhang2019, Alg. 1, Secs. 4.2 to 4.6].
#ifndef TAUTLINE_BENCH_PEERS_FLEET_AS_PRINTED_H_
#define TAUTLINE_BENCH_PEERS_FLEET_AS_PRINTED_H_

#include <utility>
#include <vector>

#include "tautline/planners/fleet/layout.h"

namespace tautline {

/// What the printed procedure finds.
struct PrintedPlan {
  /// The pair interaction graph before it is pruned: who must pass the crossing of both paths first, and who then.
  std::vector<std::pair<RobotId, RobotId>> passings;
  std::vector<std::pair<RobotId, RobotId>> pair_deadlocks;  ///< The lower robot first.
  std::vector<RobotId> detours;                             ///< In the order in which they were taken out.
  double travel_time = 0;                                   ///< Until the last robot arrives, s.
};

/// All pairs of straight paths are compared; whether a target is inside of a cable polygon is decided by counting the
/// polygon's edges to the right of it; deadlocks are dissolved by taking out the robot that is in most of them, of the
/// network's those with most events that wait for each other; those taken out drive one after the other once all others
/// have arrived. A target on a cable is taken a little to the inner side of its bend, which the paper leaves open. For
/// fleets without obstacles and in general position: it knows nothing of paths that touch or overlap, nor of three
/// paths through one point. O(n^3).
PrintedPlan PlanAsPrinted(const FleetGround& ground, const FleetLayout& layout);

}  // namespace tautline

#endif  // TAUTLINE_BENCH_PEERS_FLEET_AS_PRINTED_H_
