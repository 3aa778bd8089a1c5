// The directed reduced visibility graph: bitangents between corners, and the taut turns between them.
#ifndef TAUTLINE_HOMOTOPY_VISIBILITY_GRAPH_H_
#define TAUTLINE_HOMOTOPY_VISIBILITY_GRAPH_H_

#include <cstdint>
#include <span>
#include <vector>

#include "tautline/base/stop.h"
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
  EdgeId reverse;  ///< The same edge in the other direction.
  EdgeId onward;   ///< Where the taut ways on from its head begin; see VisibilityGraph::Onward.
};

/// What each corner sees along bitangents, one corner after the other: all that a visibility graph is made from.
struct SightList {
  std::vector<Sighting> sightings;   ///< Of each corner sorted as SeeFromCorner does.
  std::vector<std::int32_t> counts;  ///< By corner.
};

/// O(triangles seen from all corners). Throws Stopped when `watch` says stop.
SightList SeeFromAllCorners(const FreeMesh& mesh, const Corners& corners, const Watcher& watch = {});

/// Consecutive edges: all from `first` up to, not including, `last`.
struct EdgeRange {
  EdgeId first;  ///< The first edge.
  EdgeId last;   ///< Past the last edge.
};

/// Where a taut walk stands: on a corner with its obstacle on one side. The edges that leave a corner with its obstacle
/// on one side have one stance for a tail, and lie together.
using StanceId = Index<struct StanceTag>;

/// On this corner, with its obstacle on this side, which is not kNone.
constexpr StanceId StanceOf(CornerId corner, Side side) {
  return StanceId(2 * corner.value() + (side == Side::kLeft ? 0 : 1));
}
/// The same corner, with the obstacle on the other side.
constexpr StanceId Opposite(StanceId stance) { return StanceId(stance.value() ^ 1); }

/// All directed bitangents; a taut walk is a sequence of them with a taut turn at each corner between.
///
/// The edges that leave a stance are sorted by direction, turning towards the obstacle. So the taut ways on from an
/// edge are those from some edge to the end of the stance at its head: no turn has to be tested to walk on.
class VisibilityGraph {
 public:
  /// Requires that sight is symmetric and made of tangents, as SeeFromAllCorners finds it. O(e log d) for e edges, d
  /// at a corner.
  VisibilityGraph(const Corners& corners, const SightList& sight);

  /// What the graph was made from. O(e log d).
  SightList sight() const;

  /// All edges by EdgeId, those that leave one corner beside each other.
  std::span<const TautEdge> edges() const { return edges_; }
  /// An edge.
  const TautEdge& edge(EdgeId id) const { return edges_[id.index()]; }

  /// The edges that leave a corner.
  std::span<const TautEdge> OutOf(CornerId corner) const {
    const EdgeId first = first_[StanceOf(corner, Side::kLeft).index()];
    return std::span(edges_).subspan(first.index(), first_[2 * corner.index() + 2].index() - first.index());
  }

  /// How many stances there are: two for each corner.
  std::size_t stances() const { return first_.size() - 1; }
  /// The edges that leave a stance, sorted by direction, turning towards the obstacle.
  EdgeRange OutOf(StanceId stance) const { return {first_[stance.index()], first_[stance.index() + 1]}; }

  /// The edges with which a taut walk can go on after `id`. O(1).
  EdgeRange Onward(EdgeId id) const {
    const TautEdge& e = edge(id);
    return {e.onward, first_[StanceOf(e.to, e.head).index() + 1]};
  }

  /// Onward(edge(id).reverse).first, kept together for edges of one stance. It never grows along a stance.
  EdgeId OnwardOfReverse(EdgeId id) const { return onward_of_reverse_[id.index()]; }

  /// The edges with which a taut walk can go on that came from the point `from` to the corner, with the corner's
  /// obstacle on side `head`. Requires that this leg is tangent there. O(log degree).
  EdgeRange Onward(Point from, CornerId corner, Side head, const Corners& corners) const;

 private:
  void SortStances(const Corners& corners);
  void FindOnward(const Corners& corners);

  std::vector<TautEdge> edges_;
  std::vector<EdgeId> first_;  ///< By stance, and the end.
  std::vector<EdgeId> onward_of_reverse_;
};

/// Whether a curve that comes from `from`, touches `corner` with its obstacle on side `head`, and goes on to `to` bends
/// around that obstacle: a turn towards it, never straight. The line on to `to` must be tangent with the obstacle on
/// the same side.
bool IsTautTurn(Point from, Point corner, Side head, Point to);

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_VISIBILITY_GRAPH_H_
