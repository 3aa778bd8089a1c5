// The shortest path over a graph among those of one homotopy class.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_SHORTEST_IN_CLASS_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_SHORTEST_IN_CLASS_H_

#include <cstdint>
#include <optional>

#include "tautline/homotopy/taut_space.h"
#include "tautline/planners/contact_free/path_graph.h"

namespace tautline {

/// What is asked, and how hard to search.
struct ShortestInClassQuery {
  PathNodeId from;                    ///< Where the path starts.
  PathNodeId to;                      ///< Where it ends.
  Word word;                          ///< Of the path, reduced, by the rays of the space.
  double stretch = 2;                 ///< Paths longer than so many times the taut one, ...
  double slack_m = 10;                ///< ... and these metres, do not count: there are ever more other classes.
  std::int64_t max_states = 300'000;  ///< (node, word) states after which the search gives up.
};

/// The shortest path along the edges of `graph` whose reduced word is `query.word`: Dijkstra's algorithm over (node,
/// word) [Kim2014], led by a bound that never errs, the taut length of what is left of the class. So few words but
/// those of the class are ever looked at. Nothing when the graph has no such path up to the length said, a letter of
/// the word is none of the space's, or the search gave up. Requires that all edges lie in the closed free space. O(log
/// + length of a sleeve) per edge of a state.
std::optional<Polyline> ShortestInClass(const TautSpace& space, const PathGraph& graph,
                                        const ShortestInClassQuery& query);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_SHORTEST_IN_CLASS_H_
