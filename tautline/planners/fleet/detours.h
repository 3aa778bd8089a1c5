// Which robots must leave their straight paths so that nobody waits for ever.
#ifndef TAUTLINE_PLANNERS_FLEET_DETOURS_H_
#define TAUTLINE_PLANNERS_FLEET_DETOURS_H_

#include <vector>

#include "tautline/planners/fleet/event_graph.h"

namespace tautline {

/// What detours must resolve, and what they cost.
struct DetourProblem {
  const OrderGraph& graph;                             ///< Must have no circle without the robots on a detour.
  const std::vector<PairDeadlock>& pair_deadlocks;     ///< One of each pair must go.
  const std::vector<std::vector<RobotId>>& entangled;  ///< One of each of these must go as well.
  std::vector<double> costs;                           ///< How much longer each detour is, by RobotId, metres.
};

/// How long the least detours are searched for.
struct DetourOptions {
  std::size_t nodes = 200'000;  ///< Of the search trees, at most, in all.
  std::size_t rounds = 400;     ///< In which circles are looked for, at most.
  StopCheck stop = {};          ///< Asked now and then.
};

/// Robots on a detour.
struct Detours {
  std::vector<RobotId> robots;  ///< In order. Without them no deadlock is left.
  bool optimal = false;         ///< Whether it is proved that there are no fewer, nor shorter ones as few.
  std::size_t bound = 0;        ///< There are no fewer than this.
};

/// The fewest robots without which no deadlock is left, and of those the shortest detours in total. Exact by implicit
/// hitting sets [MorenoCenteno2013]: circles are found as they are needed, each a set of robots of which one must go,
/// and the least choice from those found so far is made by branch and bound in each connected part of the conflicts.
/// Where that takes more than the options allow, the choice is made greedily and thinned out, and `bound` is what the
/// search has proved until then. Throws Stopped when `stop` says so.
Detours LeastDetours(const DetourProblem& problem, const DetourOptions& options = {});

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_DETOURS_H_
