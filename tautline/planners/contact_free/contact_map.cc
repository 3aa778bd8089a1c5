#include "tautline/planners/contact_free/contact_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tautline/base/check.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// So many cells lie in a row at most.
constexpr double kMostCells = 256;

/// Whether the ring is a rectangle with axis-parallel sides.
bool IsRectangle(const Ring& ring, const Box& box) {
  if (ring.size() != 4) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point p = ring[i], next = ring[(i + 1) % 4];
    const bool corner = (p.x == box.low.x || p.x == box.high.x) && (p.y == box.low.y || p.y == box.high.y);
    if (!corner || ((p.x == next.x) == (p.y == next.y))) return false;
  }
  return true;
}

/// Narrows the interval [low, high] of t to that in which from + t * by <= limit; false where nothing is left.
bool Clip(double from, double by, double limit, double& low, double& high) {
  const double room = limit - from;
  if (by == 0) return room >= 0;
  if (by > 0) {
    high = std::min(high, room / by);
  } else {
    low = std::max(low, room / by);
  }
  return low <= high;
}

/// Whether two closed segments share a point, exactly.
bool Meet(Point a, Point b, Point c, Point d) {
  if (OnSegment(a, b, c) || OnSegment(a, b, d) || OnSegment(c, d, a) || OnSegment(c, d, b)) return true;
  return CrossProperly(a, b, c, d);
}

bool BoxHolds(const Box& box, Point p) {
  return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y;
}

Box Around(Point p, double by) { return {{p.x - by, p.y - by}, {p.x + by, p.y + by}}; }

}  // namespace

bool SegmentMeetsBox(Point a, Point b, const Box& box) {
  double low = 0, high = 1;
  const Point by = b - a;
  return Clip(a.x, by.x, box.high.x, low, high) && Clip(-a.x, -by.x, -box.low.x, low, high) &&
         Clip(a.y, by.y, box.high.y, low, high) && Clip(-a.y, -by.y, -box.low.y, low, high);
}

ContactMap::ContactMap(const FreeSpace& space, double cell_m) : box_(space.box) {
  TAUTLINE_CHECK(cell_m > 0 && !space.components.empty());
  for (const FreeComponent& component : space.components) {
    AddWall(component.outer.points, true);
    for (const BoundaryRing& hole : component.holes) AddWall(hole.points, false);
  }
  std::vector<BoxIndex::Segment> segments;
  segments.reserve(edges_.size());
  for (const Edge& edge : edges_) segments.emplace_back(edge.a, edge.b);
  index_.emplace(segments);
  MakeGrid(cell_m);
}

void ContactMap::AddWall(const Ring& ring, bool around) {
  const Box box = BoundingBox(ring);
  const auto wall = static_cast<std::int32_t>(walls_.size());
  for (std::size_t i = 0; i < ring.size(); ++i) edges_.push_back({ring[i], ring[(i + 1) % ring.size()], wall});
  Ring kept = ring;
  const RingIndex index(kept);  // Of the points, which stay where they are when their vector moves.
  walls_.push_back({std::move(kept), index, box, around, !around && IsRectangle(ring, box)});
}

void ContactMap::MakeGrid(double cell_m) {
  const Point size = box_.size();
  const double cell = std::max({cell_m, size.x / kMostCells, size.y / kMostCells});
  low_ = box_.low;
  per_m_ = 1 / cell;
  columns_ = std::max(1, static_cast<int>(std::ceil(size.x * per_m_)));
  rows_ = std::max(1, static_cast<int>(std::ceil(size.y * per_m_)));
  const double half_diagonal = cell * std::sqrt(0.5);
  std::vector<float> clear_m;
  clear_m.reserve(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const Point centre{low_.x + (column + 0.5) * cell, low_.y + (row + 0.5) * cell};
      // A millionth for the rounding of cells and of floats.
      const double distance = IsInBlockedGround(centre) ? 0 : DistanceToEdges(centre);
      const double clear = (1 - 1e-6) * distance - (1 + 1e-6) * half_diagonal;
      clear_m.push_back(static_cast<float>(std::max(0.0, clear)));
    }
  }
  clear_m_ = std::move(clear_m);
}

bool ContactMap::SegmentTouches(Point a, Point b) const {
  const Point middle = 0.5 * (a + b);
  if (ClearAround(middle) > 0.5 * Distance(a, b)) return false;
  bool touches = false;
  index_->ForEachAlong(a, b, 0, [&](std::size_t k) {
    if (touches) return;
    const Edge& edge = edges_[k];
    const Wall& wall = walls_[static_cast<std::size_t>(edge.wall)];
    touches = wall.rectangle ? SegmentMeetsBox(a, b, wall.box) : Meet(a, b, edge.a, edge.b);
  });
  return touches || IsBlocked(a);
}

bool ContactMap::DiscTouches(Point centre, double radius_m) const {
  if (ClearAround(centre) > radius_m) return false;
  bool touches = false;
  index_->ForEachNear(Around(centre, radius_m), [&](std::size_t k) {
    touches = touches || DistanceToSegment(centre, edges_[k].a, edges_[k].b) <= radius_m;
  });
  return touches || IsBlocked(centre);
}

bool ContactMap::IsBlocked(Point p) const { return ClearAround(p) <= 0 && IsInBlockedGround(p); }

bool ContactMap::IsInBlockedGround(Point p) const {
  bool inside = false;
  for (const Wall& wall : walls_) {
    if (!BoxHolds(wall.box, p)) continue;
    const Winding winding = wall.index.WindingAt(p);
    if (winding.on_boundary) return true;
    if (winding.number == 0) continue;
    if (!wall.around) return true;
    inside = true;
  }
  return !inside;
}

double ContactMap::DistanceToEdges(Point p) const {
  const Point size = box_.size();
  for (double reach = std::max(size.x, size.y) / kMostCells;; reach *= 2) {
    double best = std::numeric_limits<double>::infinity();
    index_->ForEachNear(Around(p, reach),
                        [&](std::size_t k) { best = std::min(best, DistanceToSegment(p, edges_[k].a, edges_[k].b)); });
    if (best <= reach) return best;
  }
}

}  // namespace tautline
