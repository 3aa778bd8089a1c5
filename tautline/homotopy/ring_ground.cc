#include "tautline/homotopy/ring_ground.h"

#include <algorithm>
#include <utility>

#include "tautline/geometry/polygon.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// What lies as deep as the tolerance may fall on either side of it by rounding.
constexpr double kSurely = 0.99;

template <class Visit>
void ForEachRing(const FreeComponent& component, Visit visit) {
  visit(component.outer.points);
  for (const BoundaryRing& hole : component.holes) visit(hole.points);
}

template <class Visit>
void ForEachRing(const FreeSpace& space, Visit visit) {
  for (const FreeComponent& component : space.components) ForEachRing(component, visit);
}

/// Outer rings wind once around their component, and holes take that back.
bool Holds(const FreeComponent& component, Point p) {
  int number = 0;
  bool on_boundary = false;
  ForEachRing(component, [&](const Ring& ring) {
    const Winding winding = WindingNumber(ring, p);
    number += winding.number;
    on_boundary = on_boundary || winding.on_boundary;
  });
  return on_boundary || number > 0;
}

double DistanceTo(const FreeComponent& component, Point p) {
  double least = Distance(p, component.outer.points[0]);
  ForEachRing(component, [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      least = std::min(least, DistanceToSegment(p, ring[i], ring[(i + 1) % ring.size()]));
    }
  });
  return least;
}

}  // namespace

template <class Visit>
void RingGround::ForEachEdge(Visit visit) const {
  ForEachRing(space_, [&visit](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
  });
}

std::vector<std::size_t> RingGround::ComponentsAt(Point p) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < space_.components.size(); ++i) {
    if (Holds(space_.components[i], p)) found.push_back(i);
  }
  if (!found.empty()) return found;
  double least = tolerance_;
  for (std::size_t i = 0; i < space_.components.size(); ++i) {
    const double distance = DistanceTo(space_.components[i], p);
    if (distance > least) continue;
    if (distance < least) found.clear();
    least = distance;
    found.push_back(i);
  }
  return found;
}

bool RingGround::IsBlocked(Point p) const { return !ComponentOf(space_, p, kSurely * tolerance_); }

bool RingGround::HoldsSegment(Point a, Point b, double depth) const {
  std::vector<double> cuts{0, 1};
  const auto cut_at = [&](Point meet) {
    const double at = Dot(meet - a, b - a) / Dot(b - a, b - a);
    if (at > 0 && at < 1) cuts.push_back(at);
  };
  ForEachEdge([&](Point p, Point q) {
    // Rounding may hide that edges meet the segment in their ends, as when it runs along one of them.
    if (DistanceToSegment(p, a, b) <= tolerance_) cut_at(p);
    const double side_p = Cross(b - a, p - a), side_q = Cross(b - a, q - a);
    if ((side_p > 0 && side_q > 0) || (side_p < 0 && side_q < 0) || side_p == side_q) return;
    cut_at(Lerp(p, q, side_p / (side_p - side_q)));
  });
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if (!ComponentOf(space_, Lerp(a, b, 0.5 * (cuts[i - 1] + cuts[i])), depth)) return false;
  }
  return true;
}

/// Whether the segment touches a boundary vertex that lies on another edge than its own two, or is the vertex of
/// another ring.
bool RingGround::TouchesMeeting(Point a, Point b) const {
  bool touches = false;
  ForEachEdge([&](Point vertex, Point) {
    if (touches || !OnSegment(a, b, vertex)) return;
    int edges = 0;
    ForEachEdge([&](Point p, Point q) { edges += OnSegment(p, q, vertex) ? 1 : 0; });
    touches = edges > 2;
  });
  return touches;
}

bool RingGround::SurelyHolds(std::span<const Point> polyline) const {
  for (const Point p : polyline) {
    if (!ComponentOf(space_, p)) return false;
  }
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    const Point a = polyline[i - 1], b = polyline[i];
    if (a != b && (!HoldsSegment(a, b, 0) || TouchesMeeting(a, b))) return false;
  }
  return true;
}

bool RingGround::BendsAroundObstacle(Point a, Point b, Point c) const {
  const int turn = Orientation(a, b, c);
  bool around = false;
  ForEachRing(space_, [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size() && !around; ++i) {
      if (ring[i] != b) continue;
      const Point before = ring[(i + ring.size() - 1) % ring.size()], after = ring[(i + 1) % ring.size()];
      const auto on_inner_side = [&](Point p, Point q, Point r) { return Orientation(p, q, r) * turn >= 0; };
      around = turn != 0 && on_inner_side(a, b, before) && on_inner_side(a, b, after) && on_inner_side(b, c, before) &&
               on_inner_side(b, c, after);
    }
  });
  return around;
}

Word RingGround::WordOf(std::span<const Point> curve) const {
  Word word;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const Point p = curve[i - 1], q = curve[i];
    const bool rightward = p.x < q.x;
    std::vector<std::pair<double, ObstacleId>> crossed;
    for (std::size_t k = 0; k < space_.islands.size(); ++k) {
      const Point ray = space_.islands[k].representative;
      if ((p.x < ray.x) == (q.x < ray.x)) continue;
      if (Orientation(rightward ? p : q, rightward ? q : p, ray) < 0) crossed.emplace_back(ray.x, ObstacleId(k));
    }
    std::sort(crossed.begin(), crossed.end());
    if (!rightward) std::reverse(crossed.begin(), crossed.end());
    for (const auto& [x, island] : crossed) word.Append({island, !rightward});
  }
  return word;
}

}  // namespace tautline
