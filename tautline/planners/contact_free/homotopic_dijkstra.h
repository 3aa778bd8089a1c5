// The first baseline: the shortest path on a lattice in a given homotopy class.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_HOMOTOPIC_DIJKSTRA_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_HOMOTOPIC_DIJKSTRA_H_

#include <cstdint>
#include <optional>

#include "tautline/planners/contact_free/class_path_query.h"

namespace tautline {

/// How fine, and how hard to search.
struct HomotopicDijkstraOptions {
  double step_m = 0.25;               ///< The side of a cell, metres. Positive.
  std::int64_t max_states = 300'000;  ///< (cell, word) states after which the search gives up.
};

/// The shortest path of the class over the 8-connected lattice in the grown free space of `ground`
/// [Shimada2024, Sec. 6.3] [Kim2014]. Nothing where the lattice has no such path, an end is blocked, or the search gave
/// up. Requires a step that BuildPathLattice accepts. O(cells), and ShortestInClass.
std::optional<Polyline> HomotopicDijkstra(const TautGround& ground, const ClassPathQuery& query,
                                          const HomotopicDijkstraOptions& options = {});

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_HOMOTOPIC_DIJKSTRA_H_
