#include "tautline/planners/contact_free/homotopic_dijkstra.h"

#include "tautline/base/check.h"
#include "tautline/planners/contact_free/path_lattice.h"
#include "tautline/planners/contact_free/shortest_in_class.h"

namespace tautline {
namespace {

/// A lattice path is longer than the taut one by 8.24 % at most, and by some steps at bends; more than this means that
/// a passage of the class falls between the points.
constexpr double kStretch = 1.25;
constexpr double kSlackSteps = 20;

}  // namespace

std::optional<Polyline> HomotopicDijkstra(const TautGround& ground, const ClassPathQuery& query,
                                          const HomotopicDijkstraOptions& options) {
  const auto open = LeaveSocket(ground, query);
  if (!open) return std::nullopt;
  const auto lattice = BuildPathLattice(ground.space(), open->open.from, open->open.to, options.step_m);
  TAUTLINE_CHECK(lattice);
  auto path = ShortestInClass(ground.space(), lattice->graph,
                              {.from = lattice->from,
                               .to = lattice->to,
                               .word = open->open.word,
                               .stretch = kStretch,
                               .slack_m = kSlackSteps * options.step_m,
                               .max_states = options.max_states});
  if (!path) return std::nullopt;
  return open->FromBase(*std::move(path));
}

}  // namespace tautline
