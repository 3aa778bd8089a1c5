// Systematic untangling: a search tree over intermediate targets.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_UNTANGLE_SEARCH_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_UNTANGLE_SEARCH_H_

#include "tautline/planners/grid_manifold/untangler.h"

namespace tautline {

/// How much is searched.
struct UntangleSearchOptions {
  int max_trials = 500;  ///< Motions to simulate at most.
  int spacing = 8;       ///< Columns and rows between the first samples; halved when no state is left. A power of two.
};

/// Finds targets after which the goal can be visited, best first: from states whose shortest way to the goal the cable
/// blocks in the fewest places, then from those that took the least time. From each, the heuristic's candidates and a
/// sampling of the accessible region are tried; states that look the same (StateKey) count once. When no state is left,
/// the sampling is refined, up to every vertex: then `exhausted`. After the first way it goes on for as many trials
/// again, unless the visit has rules of acceptance, and answers with the quickest: with more trials it is never worse.
/// What [Igarashi2010, Sec. 4.3] leaves as an alternative to its heuristic. Memory: a cable for each state.
UntangleResult SearchUntangling(RobotDriver& driver, const GoalVisit& visit, const DriveState& start,
                                const UntangleSearchOptions& options);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_UNTANGLE_SEARCH_H_
