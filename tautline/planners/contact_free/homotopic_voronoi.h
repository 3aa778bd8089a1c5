// The second baseline: the shortest path along the Voronoi diagram in a given homotopy class.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_HOMOTOPIC_VORONOI_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_HOMOTOPIC_VORONOI_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "tautline/planners/contact_free/class_path_query.h"
#include "tautline/planners/contact_free/path_graph.h"

namespace tautline {

/// How fine, and how hard to search.
struct HomotopicVoronoiOptions {
  double sample_m = 0.1;              ///< Curved edges become chords no longer than this, metres. Positive.
  std::int64_t max_states = 300'000;  ///< (node, word) states after which the search gives up.
};

/// The Voronoi diagram of the edges of all boundaries: the places as far from one boundary as from another. What is
/// nearer to them than the grown free space allows is left out. Immutable.
class VoronoiRoadmap {
 public:
  /// The diagram of the ungrown boundaries, within the grown free space of `ground`; both are to stay. Boundaries are
  /// rounded to a grid of 2^-30 of the extent of the world. O(n log n) for n boundary edges, and the chords.
  /// [Fortune1987]
  VoronoiRoadmap(const TautGround& ground, double sample_m);

  /// The roadmap itself.
  const PathGraph& graph() const { return graph_; }

  /// The shortest path along the roadmap in a class: straight from its start to the nearest node in sight, and from the
  /// nearest node in sight of its end; where the roadmap is in several pieces, to that of each. Nothing where there is
  /// none, an end is blocked, or the search gave up. O(nodes), and ShortestInClass.
  std::optional<Polyline> PathInClass(const ClassPathQuery& query, std::int64_t max_states = 300'000) const;

 private:
  std::vector<PathNodeId> NearestInSight(Place place) const;

  const TautGround* ground_;
  PathGraph graph_;
  std::vector<std::int32_t> piece_;  ///< By node: which connected piece it belongs to.
  std::int32_t pieces_ = 0;
};

/// The path of a roadmap that is made for one query. [Shimada2024, Sec. 6.3]
std::optional<Polyline> HomotopicVoronoi(const TautGround& ground, const ClassPathQuery& query,
                                         const HomotopicVoronoiOptions& options = {});

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_HOMOTOPIC_VORONOI_H_
