#include "tautline/planners/contact_free/homotopic_dijkstra.h"

#include "tautline/base/check.h"
#include "tautline/planners/contact_free/path_lattice.h"
#include "tautline/planners/contact_free/shortest_in_class.h"

namespace tautline {

std::optional<Polyline> HomotopicDijkstra(const TautGround& ground, const ClassPathQuery& query,
                                          const HomotopicDijkstraOptions& options) {
  const auto open = LeaveSocket(ground, query);
  if (!open) return std::nullopt;
  const auto lattice = BuildPathLattice(ground.space(), open->open.from, open->open.to, options.step_m);
  TAUTLINE_CHECK(lattice);
  auto path = ShortestInClass(
      ground.space(), lattice->graph,
      {.from = lattice->from, .to = lattice->to, .word = open->open.word, .max_states = options.max_states});
  if (!path) return std::nullopt;
  return open->FromBase(*std::move(path));
}

}  // namespace tautline
