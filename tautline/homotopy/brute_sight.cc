#include "tautline/homotopy/brute_sight.h"

#include <algorithm>

#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

bool StrictlyOnSegment(Point a, Point b, Point p) { return p != a && p != b && OnSegment(a, b, p); }

/// The points strictly between a and b on the segment, in order from a.
std::vector<Point> PointsBetween(Point a, Point b, std::span<const Point> points) {
  std::vector<Point> between;
  for (const Point p : points) {
    if (StrictlyOnSegment(a, b, p)) between.push_back(p);
  }
  // Points on one line are in order of their coordinates.
  std::sort(between.begin(), between.end());
  if (b < a) std::reverse(between.begin(), between.end());
  return between;
}

Ring WithPointsOnIt(const Ring& ring, std::span<const Point> points) {
  Ring dense;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    dense.push_back(ring[i]);
    for (const Point p : PointsBetween(ring[i], ring[(i + 1) % ring.size()], points)) dense.push_back(p);
  }
  return dense;
}

/// Whether the direction towards p lies in the closed free sector of a node on the boundary.
bool InSector(const SightNode& node, Point p) {
  const int turn = Orientation(node.previous, node.point, node.next);
  const bool left_of_next = Orientation(node.point, node.next, p) >= 0;
  const bool left_of_previous = Orientation(node.previous, node.point, p) >= 0;
  if (turn > 0) return left_of_next && left_of_previous;
  if (turn == 0) return left_of_next;
  return left_of_next || left_of_previous;
}

Ring Oriented(Ring ring, bool counter_clockwise) {
  if ((SignedArea(ring) > 0) != counter_clockwise) std::reverse(ring.begin(), ring.end());
  return ring;
}

}  // namespace

BruteSight::BruteSight(std::span<const Ring> rings, std::span<const Point> points)
    : points_(points.begin(), points.end()) {
  for (const Ring& ring : rings) points_.insert(points_.end(), ring.begin(), ring.end());
  std::sort(points_.begin(), points_.end());
  points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  for (const Ring& ring : rings) {
    const Ring& dense = rings_.emplace_back(WithPointsOnIt(ring, points_));
    const std::size_t n = dense.size();
    for (std::size_t i = 0; i < n; ++i) {
      nodes_.push_back({dense[i], true, dense[(i + n - 1) % n], dense[(i + 1) % n]});
    }
  }
  for (const Point p : points_) {
    int winding = 0;
    bool on_boundary = false;
    for (const Ring& ring : rings) {
      const Winding here = WindingNumber(ring, p);
      winding += here.number;
      on_boundary = on_boundary || here.on_boundary;
    }
    if (!on_boundary && winding > 0) nodes_.push_back({p, false, {}, {}});
  }
}

std::vector<std::size_t> BruteSight::NodesAt(Point p) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].point == p) found.push_back(i);
  }
  return found;
}

bool BruteSight::PassesThrough(Point p, Point from, Point to) const {
  return std::any_of(nodes_.begin(), nodes_.end(), [&](const SightNode& node) {
    return node.point == p && (!node.on_boundary || (InSector(node, from) && InSector(node, to)));
  });
}

bool BruteSight::CrossesBoundary(Point a, Point b) const {
  return std::any_of(rings_.begin(), rings_.end(), [a, b](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (CrossProperly(a, b, ring[i], ring[(i + 1) % ring.size()])) return true;
    }
    return false;
  });
}

bool BruteSight::Sees(std::size_t a, std::size_t b) const {
  const SightNode &from = nodes_[a], &to = nodes_[b];
  if (from.point == to.point) return a == b;
  if (from.on_boundary && !InSector(from, to.point)) return false;
  if (to.on_boundary && !InSector(to, from.point)) return false;
  for (const Point p : PointsBetween(from.point, to.point, points_)) {
    if (!PassesThrough(p, from.point, to.point)) return false;
  }
  return !CrossesBoundary(from.point, to.point);
}

std::vector<Ring> RingsOf(const FreeSpace& space) {
  std::vector<Ring> rings;
  for (const FreeComponent& component : space.components) {
    rings.push_back(component.outer.points);
    for (const BoundaryRing& hole : component.holes) rings.push_back(hole.points);
  }
  return rings;
}

std::vector<Ring> RingsOf(const World& world) {
  std::vector<Ring> rings{Oriented(world.outline, true)};
  for (const Obstacle& obstacle : world.obstacles) rings.push_back(Oriented(obstacle.polygon->outer, false));
  return rings;
}

}  // namespace tautline
