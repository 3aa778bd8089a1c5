#include "tautline/planners/cable_workspace/side_classes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// Whether two segments cross in a point inside both.
bool CrossInside(Point a, Point b, Point c, Point d) {
  return Orientation(a, b, c) * Orientation(a, b, d) < 0 && Orientation(c, d, a) * Orientation(c, d, b) < 0;
}

bool IsOnRing(const TautSpace& space, const BoundaryRing& ring, Point p) {
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    const Point a = ring.points[i], b = ring.points[(i + 1) % ring.points.size()];
    if (DistanceToSegment(p, a, b) <= space.tolerance()) return true;
  }
  return false;
}

/// On the ring around a component, and on none around blocked ground inside of one.
bool IsOnOuterWall(const TautSpace& space, Point p) {
  bool outer = false;
  for (const FreeComponent& component : space.free_space().components) {
    outer = outer || IsOnRing(space, component.outer, p);
    for (const BoundaryRing& hole : component.holes) {
      if (IsOnRing(space, hole, p)) return false;
    }
  }
  return outer;
}

/// Depth first along taut walks.
class SideListing {
 public:
  SideListing(const TautSpace& space, const Anchors& anchors, std::size_t side, const TollGraph& graph,
              const RayTolls& tolls, const SideClassOptions& options)
      : space_(space),
        from_(anchors[side].exit),
        to_(anchors[NextAnchor(side, anchors.size())].exit),
        tolls_(tolls),
        options_(options),
        edge_refunds_(graph.RefundOfEdges(tolls)),
        cheapest_(graph.CheapestFromCorners(tolls, side)),
        field_(space, to_),
        is_passed_(space.graph().stances(), false) {
    field_.GrowTo(options.max_length);
  }

  std::vector<TautPath> Run() {
    Walk start(from_);
    start.rooted = true;
    points_ = {from_.point};
    Walk straight = start;
    if (!WalkStraight(space_.mesh(), to_.point, straight)) {
      Finish({Distance(from_.point, to_.point), RefundOf(space_, tolls_, std::vector{from_.point, to_.point})});
    }
    for (const FirstLeg& first : FirstLegsFrom(space_, start)) {
      const Point corner = space_.corners()[first.leg.corner].point;
      const double refund = RefundOf(space_, tolls_, std::vector{from_.point, corner});
      Visit(first.leg.corner, first.leg.side, first.onward, {first.leg.length, refund});
    }
    return std::move(found_);
  }

 private:
  struct Spent {
    double length;
    double refund;
  };

  /// Goes on from a corner that the walk reaches now.
  void Visit(CornerId corner, Side head, EdgeRange onward, Spent spent) {
    options_.budget->Spend();
    const Point at = space_.corners()[corner].point, before = points_.back();
    if (spent.length - spent.refund + cheapest_[corner.index()] > options_.max_cost || CrossesItself(at)) return;
    const std::size_t stance = StanceOf(corner, head).index();
    if (options_.drop_loops && is_passed_[stance]) return;
    const bool was_passed = is_passed_[stance];
    is_passed_[stance] = true;
    points_.push_back(at);
    if (const auto leg = field_.LastLeg(corner, head, before); leg && !CrossesItself(to_.point)) {
      Finish({spent.length + *leg, spent.refund + RefundOf(space_, tolls_, std::vector{at, to_.point})});
    }
    for (EdgeId id = onward.first; id < onward.last; ++id) {
      const TautEdge& edge = space_.graph().edge(id);
      const double length = spent.length + edge.length;
      if (!(length + field_.Beyond(id) <= options_.max_length)) continue;
      Visit(edge.to, edge.head, space_.graph().Onward(id), {length, spent.refund + edge_refunds_[id.index()]});
    }
    points_.pop_back();
    is_passed_[stance] = was_passed;
  }

  bool CrossesItself(Point next) const {
    if (!options_.drop_crossing) return false;
    for (std::size_t i = 0; i + 2 < points_.size(); ++i) {
      if (CrossInside(points_[i], points_[i + 1], points_.back(), next)) return true;
    }
    return false;
  }

  void Finish(Spent spent) {
    if (spent.length > options_.max_length || spent.length - spent.refund > options_.max_cost) return;
    Polyline points = points_;
    points.push_back(to_.point);
    found_.push_back(space_.MakePath(std::move(points)));
  }

  const TautSpace& space_;
  Place from_;
  Place to_;
  const RayTolls& tolls_;
  const SideClassOptions& options_;
  std::vector<double> edge_refunds_;
  std::vector<double> cheapest_;  ///< From each corner.
  GoalField field_;
  std::vector<bool> is_passed_;  ///< By stance.
  Polyline points_;              ///< So far.
  std::vector<TautPath> found_;
};

}  // namespace

bool LoopsCross(const TautSpace& space, const Place& from, const Place& to) {
  return IsOnOuterWall(space, from.point) && IsOnOuterWall(space, to.point);
}

std::vector<TautPath> ListSideClasses(const TautSpace& space, const Anchors& anchors, std::size_t side,
                                      const TollGraph& graph, const RayTolls& tolls, const SideClassOptions& options) {
  return SideListing(space, anchors, side, graph, tolls, options).Run();
}

}  // namespace tautline
