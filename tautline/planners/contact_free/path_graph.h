// A graph of points and free straight segments: what searches on lattices and roadmaps run over.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_PATH_GRAPH_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_PATH_GRAPH_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "tautline/base/index.h"
#include "tautline/geometry/polygon.h"

namespace tautline {

/// A point of a PathGraph.
using PathNodeId = Index<struct PathNodeTag>;

/// Points in the plane, joined by straight segments that can be passed both ways. Immutable.
class PathGraph {
 public:
  /// Two nodes that are joined.
  using Edge = std::pair<PathNodeId, PathNodeId>;

  /// Requires edges between different points of `points`; one given twice counts once. O(points + edges log edges).
  PathGraph(std::vector<Point> points, std::vector<Edge> edges);

  /// How many points there are.
  std::size_t size() const { return points_.size(); }
  /// Where a node is, metres.
  Point point(PathNodeId id) const { return points_[id.index()]; }
  /// The nodes that a node is joined to, by number.
  std::span<const PathNodeId> Neighbours(PathNodeId id) const {
    const std::size_t first = begin_[id.index()];
    return std::span(to_).subspan(first, begin_[id.index() + 1] - first);
  }
  /// How long the segment between two nodes is, metres.
  double Length(PathNodeId from, PathNodeId to) const { return Distance(point(from), point(to)); }

  /// The distance to a node along the graph, from every node; infinite where there is no way. Dijkstra:
  /// O(edges log edges). [Dijkstra1959]
  std::vector<double> DistancesTo(PathNodeId goal) const;

  /// The points of some nodes.
  Polyline PointsOf(std::span<const PathNodeId> nodes) const;

 private:
  std::vector<Point> points_;
  std::vector<std::size_t> begin_;
  std::vector<PathNodeId> to_;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_PATH_GRAPH_H_
