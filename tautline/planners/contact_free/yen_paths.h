// The k shortest simple paths between two nodes of a graph.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_YEN_PATHS_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_YEN_PATHS_H_

#include <vector>

#include "tautline/base/stop.h"
#include "tautline/planners/contact_free/path_graph.h"

namespace tautline {

/// A path over a graph that visits no node twice.
struct SimplePath {
  std::vector<PathNodeId> nodes;  ///< From start to end.
  double length = 0;              ///< Metres.
};

/// Between which nodes, and how many.
struct YenQuery {
  PathNodeId from;            ///< Where all paths start.
  PathNodeId to;              ///< Where they end; another node.
  int count = 120;            ///< How many. [Shimada2024, Sec. 4.1]
  KeepGoing keep_going = {};  ///< Asked now and then; at a no the search throws Stopped.
};

/// The shortest simple paths, shortest first; fewer where there are no more. Yen's algorithm [Yen1971] with Lawler's
/// modification [Lawler1972]: a path branches off only at or behind the place where it left its parent, and no path is
/// found twice. Each branch is an A* search led by the distance to the end without any ban, which never errs; paths of
/// equal length come in the order in which they were found. O(count * nodes of a path) branches.
std::vector<SimplePath> YenPaths(const PathGraph& graph, const YenQuery& query);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_YEN_PATHS_H_
