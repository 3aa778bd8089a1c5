#include "tautline/homotopy/funnel_tree.h"

#include "tautline/base/check.h"
#include "tautline/geometry/predicates.h"

namespace tautline {

FunnelTree::FunnelTree(const FreeMesh& mesh, const Walk& walk) : mesh_(mesh), start_(walk.from) {
  trunk_ = Plant(walk.sleeve.front());
  for (const TriangleId triangle : walk.sleeve.triangles()) trunk_ = Step(trunk_, triangle);
}

/// The class of walks that stay in a triangle that holds the start.
FunnelTree::NodeId FunnelTree::Plant(TriangleId first) {
  const SpotId start = Add(start_, {}, {});
  nodes_.push_back({first, {}, {start, start, start}});
  return NodeId(nodes_.size() - 1);
}

FunnelTree::SpotId FunnelTree::Add(Point point, VertexId vertex, SpotId before) {
  const double length = before.valid() ? At(before).length + Distance(At(before).point, point) : 0;
  spots_.push_back({point, vertex, before, length});
  return SpotId(spots_.size() - 1);
}

FunnelTree::NodeId FunnelTree::GoStraight(NodeId id, Point at, bool free_to_turn, Point to) {
  Walk walk(Place{at, nodes_[id.index()].triangle});
  walk.rooted = !free_to_turn;
  TAUTLINE_CHECK(!WalkStraight(mesh_, to, walk));
  if (walk.sleeve.front() != nodes_[id.index()].triangle) id = Plant(walk.sleeve.front());
  for (const TriangleId next : walk.sleeve.triangles()) id = Step(id, next);
  return id;
}

/// The class after a step to a neighbouring triangle (or none); a step that is undone leads back to the parent.
FunnelTree::NodeId FunnelTree::Step(NodeId id, TriangleId next) {
  const Node node = nodes_[id.index()];
  if (node.triangle == next) return id;
  if (node.parent.valid() && nodes_[node.parent.index()].triangle == next) return node.parent;
  const Triangle& here = mesh_.triangle(node.triangle);
  const int i = here.IndexOf(next);
  // Leaving across the side from Next(i) to Previous(i) with the triangle on its left: Next(i) is on the right.
  const VertexId right = here.vertex(Next(i)), left = here.vertex(Previous(i));
  Funnel funnel = node.funnel;
  if (At(funnel.right).vertex != right) {
    const SpotId before = TangentFromRight(funnel, mesh_.point(right));
    funnel.right = Add(mesh_.point(right), right, before);
  }
  if (At(funnel.left).vertex != left) {
    const SpotId before = TangentFromLeft(funnel, mesh_.point(left));
    funnel.left = Add(mesh_.point(left), left, before);
  }
  nodes_.push_back({next, id, funnel});
  return NodeId(nodes_.size() - 1);
}

/// The spot from which the taut curve to p goes straight, where p takes the place of the funnel's right tip. Moves the
/// apex when p lies beyond the left chain.
FunnelTree::SpotId FunnelTree::TangentFromRight(Funnel& funnel, Point p) const {
  SpotId spot = funnel.right;
  while (spot != funnel.apex && Orientation(At(At(spot).before).point, At(spot).point, p) >= 0) spot = At(spot).before;
  if (spot != funnel.apex) return spot;
  // The spots of the left chain that p lies beyond reach from the apex up to the last one that says so.
  SpotId tangent = funnel.apex;
  for (spot = funnel.left; spot != funnel.apex; spot = At(spot).before) {
    if (Orientation(At(At(spot).before).point, At(spot).point, p) > 0) {
      tangent = spot;
      break;
    }
  }
  funnel.apex = tangent;
  return tangent;
}

FunnelTree::SpotId FunnelTree::TangentFromLeft(Funnel& funnel, Point p) const {
  SpotId spot = funnel.left;
  while (spot != funnel.apex && Orientation(At(At(spot).before).point, At(spot).point, p) <= 0) spot = At(spot).before;
  if (spot != funnel.apex) return spot;
  SpotId tangent = funnel.apex;
  for (spot = funnel.right; spot != funnel.apex; spot = At(spot).before) {
    if (Orientation(At(At(spot).before).point, At(spot).point, p) < 0) {
      tangent = spot;
      break;
    }
  }
  funnel.apex = tangent;
  return tangent;
}

FunnelTree::Tether FunnelTree::Pull(NodeId id, Point end) const {
  Funnel funnel = nodes_[id.index()].funnel;
  SpotId spot = TangentFromRight(funnel, end);
  const double length = At(spot).length + Distance(At(spot).point, end);
  // Back over repeated points and straight turns, which arise where a curve starts or ends on a vertex or grazes one.
  while (At(spot).before.valid()) {
    const Point before = At(At(spot).before).point;
    if (At(spot).point != end && before != At(spot).point && Orientation(before, At(spot).point, end) != 0) break;
    spot = At(spot).before;
  }
  return {length, At(spot).point};
}

}  // namespace tautline
