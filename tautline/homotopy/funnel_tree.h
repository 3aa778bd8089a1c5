// The taut curves of many classes from one start, each found from the one that it continues.
#ifndef TAUTLINE_HOMOTOPY_FUNNEL_TREE_H_
#define TAUTLINE_HOMOTOPY_FUNNEL_TREE_H_

#include <cstdint>
#include <vector>

#include "tautline/homotopy/cover.h"

namespace tautline {

/// A part of the universal cover around one start: sleeves that share their beginnings, each with its funnel. Where
/// PullTaut takes the whole sleeve, a step here takes the triangles that are new.
class FunnelTree {
 public:
  using NodeId = Index<struct FunnelNodeTag>;  ///< A class of walks from the start, by its last triangle.

  /// Begins with the class of a walk. O(n) for its n triangles.
  FunnelTree(const FreeMesh& mesh, const Walk& walk);

  /// The class that the tree was begun with.
  NodeId trunk() const { return trunk_; }

  /// The class after going straight on to `to` from `at`, where a walk of class `id` stands: in its last triangle, or
  /// on the start itself and, if `free_to_turn`, not bound to its sector yet. Requires that the segment is free.
  /// O(triangles crossed) but for long chains of a funnel that the segment folds over.
  NodeId GoStraight(NodeId id, Point at, bool free_to_turn, Point to);

  /// The taut curve of a class.
  struct Tether {
    double length = 0;  ///< Metres from the start.
    Point bend;         ///< The last point before the end where it bends, or the start.
  };

  /// To a point in the last triangle of the class. O(chain).
  Tether Pull(NodeId id, Point end) const;

 private:
  using SpotId = Index<struct SpotTag>;

  /// A vertex in the cover with the taut curve to it: a node of the tree of shortest paths.
  struct Spot {
    Point point;
    VertexId vertex;  ///< Invalid for the start.
    SpotId before;
    double length;
  };

  /// Two inward-convex chains from the apex, by their tips; they run back along Spot::before.
  struct Funnel {
    SpotId left, right, apex;
  };

  struct Node {
    TriangleId triangle;
    NodeId parent;
    Funnel funnel;
  };

  NodeId Plant(TriangleId first);
  NodeId Step(NodeId id, TriangleId next);
  const Spot& At(SpotId id) const { return spots_[id.index()]; }
  SpotId Add(Point point, VertexId vertex, SpotId before);
  SpotId TangentFromRight(Funnel& funnel, Point p) const;
  SpotId TangentFromLeft(Funnel& funnel, Point p) const;

  const FreeMesh& mesh_;
  Point start_;
  std::vector<Spot> spots_;
  std::vector<Node> nodes_;
  NodeId trunk_;
};

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_FUNNEL_TREE_H_
