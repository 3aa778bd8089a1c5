#include "tautline/planners/cable_workspace/region.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "tautline/base/check.h"

namespace tautline {
namespace {

/// Calls visit(side, segment, a, b) for every piece of the sides, stubs left out.
template <class Visit>
void ForEachPiece(const WorkspaceBoundary& boundary, Visit visit) {
  for (std::size_t side = 0; side < boundary.sides.size(); ++side) {
    const Polyline& points = boundary.sides[side].path.points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) visit(side, i, points[i], points[i + 1]);
  }
}

}  // namespace

WorkspaceRegion::WorkspaceRegion(const CableGround& ground, const Anchors& anchors, const WorkspaceBoundary& boundary)
    : ground_(ground), anchors_(anchors), boundary_(boundary) {
  Walk walk(anchors[0].exit);
  walk.rooted = true;
  for (const BoundarySide& side : boundary.sides) {
    to_anchor_.push_back(walk);
    walk = Joined(ground.space().mesh(), walk, side.walk);
  }
}

Containment WorkspaceRegion::Classify(Point p) const {
  bool on_boundary = false;
  ForEachPiece(boundary_, [&](std::size_t, std::size_t, Point a, Point b) {
    on_boundary = on_boundary || DistanceToSegment(p, a, b) <= ground_.space().tolerance();
  });
  if (on_boundary) return Containment::kBoundary;
  const Winding winding = WindingNumber(boundary_.ring, p);
  return winding.number != 0 && !winding.on_boundary ? Containment::kInside : Containment::kOutside;
}

std::optional<Walk> WorkspaceRegion::WayAlong(std::size_t side, std::size_t segment, Point on_boundary, Point p) const {
  const Polyline& points = boundary_.sides[side].path.points;
  std::optional<Walk> walk = to_anchor_[side];
  Polyline way(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(segment) + 1);
  way.push_back(on_boundary);
  way.push_back(p);
  if (ground_.space().Follow(way, walk)) return std::nullopt;
  walk->rooted = true;
  return walk;
}

double WorkspaceRegion::ReachOfWays(Point p, Containment position) const {
  const double tolerance = ground_.space().tolerance();
  if (position != Containment::kInside) return tolerance;
  double nearest = std::numeric_limits<double>::infinity();
  ForEachPiece(boundary_, [&](std::size_t, std::size_t, Point a, Point b) {
    nearest = std::min(nearest, DistanceToSegment(p, a, b));
  });
  return nearest + tolerance;
}

bool WorkspaceRegion::GoesAround(const Walk& way) const {
  Ring towards;
  for (std::size_t i = 0; i < anchors_.size(); ++i) {
    const TautCurve cable = PullTaut(ground_.space().mesh(), CableTo(i, way));
    if (cable.points.size() > 1) towards.push_back(cable.points[cable.points.size() - 2].point);
  }
  const Winding winding = WindingNumber(towards, way.at);
  return winding.number != 0 && !winding.on_boundary;
}

std::vector<Walk> WorkspaceRegion::WaysTo(Point p) const {
  const Containment position = Classify(p);
  const auto place = ground_.space().Locate(p);
  if (position == Containment::kOutside || !place) return {};
  // A point on the boundary is reached along every piece that it lies on, one inside from the nearest piece.
  const double reach = ReachOfWays(place->point, position);
  const auto sectors = ground_.space().mesh().Sectors(*place);
  const auto settle = [&](Walk& way) {
    return std::any_of(sectors.begin(), sectors.end(),
                       [&](const Place& sector) { return TurnInto(ground_.space().mesh(), sector.triangle, way); });
  };
  std::vector<Walk> ways;
  ForEachPiece(boundary_, [&](std::size_t side, std::size_t segment, Point a, Point b) {
    if (DistanceToSegment(p, a, b) > reach && DistanceToSegment(place->point, a, b) > reach) return;
    auto way = WayAlong(side, segment, NearestOnSegment(place->point, a, b), place->point);
    if (!way || !settle(*way)) return;
    const auto same = [&way](const Walk& other) { return other.sleeve == way->sleeve; };
    if (std::none_of(ways.begin(), ways.end(), same)) ways.push_back(*std::move(way));
  });
  if (position != Containment::kInside || ways.size() < 2) return ways;
  // The boundary touches itself where it is nearest, and p is on one side of that.
  const auto way = std::find_if(ways.begin(), ways.end(), [this](const Walk& w) { return GoesAround(w); });
  return {way == ways.end() ? ways.front() : *way};
}

Walk WorkspaceRegion::CableTo(std::size_t anchor, const Walk& way) const {
  return Joined(ground_.space().mesh(), Reversed(to_anchor_[anchor]), way);
}

Walk WorkspaceRegion::Between(const Walk& from_way, const Walk& to_way) const {
  return Joined(ground_.space().mesh(), Reversed(from_way), to_way);
}

}  // namespace tautline
