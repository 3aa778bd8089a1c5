// The directed reduced visibility graph: bitangents between corners, and the taut turns between them.
#ifndef TAUTLINE_HOMOTOPY_VISIBILITY_GRAPH_H_
#define TAUTLINE_HOMOTOPY_VISIBILITY_GRAPH_H_

#include <cstdint>
#include <span>
#include <vector>

#include "tautline/homotopy/visibility.h"

namespace tautline {

using EdgeId = Index<struct EdgeTag>;  ///< A directed edge of the reduced visibility graph.

/// A directed bitangent between two corners.
struct TautEdge {
  /// Where it starts.
  CornerId from;
  /// Where it ends.
  CornerId to;
  double length = 0;  ///< Metres.
  /// The side of the obstacle at `from`, for a traveller along the edge.
  Side tail = Side::kNone;
  /// The side of the obstacle at `to`, for a traveller along the edge.
  Side head = Side::kNone;
};

/// All directed bitangents; a taut walk is a sequence of them with a taut turn at each corner between.
class VisibilityGraph {
 public:
  /// O(triangles seen from all corners).
  VisibilityGraph(const FreeMesh& mesh, const Corners& corners);

  /// All edges by EdgeId, those that leave one corner beside each other.
  std::span<const TautEdge> edges() const { return edges_; }
  /// An edge.
  const TautEdge& edge(EdgeId id) const { return edges_[id.index()]; }

  /// The edges that leave a corner are first(corner) .. first(corner) + OutOf(corner).size() - 1.
  std::span<const TautEdge> OutOf(CornerId corner) const {
    return std::span(edges_).subspan(first_[corner.index()], first_[corner.index() + 1] - first_[corner.index()]);
  }
  /// The first edge that leaves a corner; the id of the next corner's first when none does.
  EdgeId First(CornerId corner) const { return EdgeId(first_[corner.index()]); }

  /// The same edge in the other direction.
  EdgeId Reverse(EdgeId id) const { return reverse_[id.index()]; }

 private:
  std::vector<TautEdge> edges_;
  std::vector<std::size_t> first_;
  std::vector<EdgeId> reverse_;
};

/// Whether a curve that comes from `from`, touches `corner` with its obstacle on side `head`, and goes on to `to` bends
/// around that obstacle: a turn towards it, never straight. The line on to `to` must be tangent with the obstacle on
/// the same side.
bool IsTautTurn(Point from, Point corner, Side head, Point to);

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_VISIBILITY_GRAPH_H_
