#include "tautline/geometry/polygon.h"

#include <algorithm>
#include <iterator>

#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// The x coordinates at which the horizontal line through `y` crosses the ring's edges (half-open in y), unsorted.
void AddCrossings(std::span<const Point> ring, double y, std::vector<double>& xs) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    if ((a.y <= y) == (b.y <= y)) continue;
    xs.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
  }
}

/// The middle of the longest interval inside the polygon on the horizontal line through `y`, and its length.
std::pair<Point, double> LongestInterval(const PolygonWithHoles& polygon, double y) {
  std::vector<double> xs;
  AddCrossings(polygon.outer, y, xs);
  for (const Ring& hole : polygon.holes) AddCrossings(hole, y, xs);
  std::sort(xs.begin(), xs.end());
  std::pair<Point, double> best{{0, y}, -1};
  for (std::size_t i = 0; i + 1 < xs.size(); i += 2) {
    if (xs[i + 1] - xs[i] > best.second) best = {{0.5 * (xs[i] + xs[i + 1]), y}, xs[i + 1] - xs[i]};
  }
  return best;
}

Point Centroid(std::span<const Point> ring) {
  Point sum{0, 0};
  double area = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Point u = ring[i] - ring[0], v = ring[i + 1] - ring[0];
    const double cross = Cross(u, v);
    sum = sum + cross / 3 * (u + v);
    area += cross;
  }
  return area == 0 ? ring[0] : ring[0] + 1 / area * sum;
}

}  // namespace

void Box::Add(Point p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y)};
}

Box BoundingBox(std::span<const Point> points) {
  Box box;
  for (const Point p : points) box.Add(p);
  return box;
}

double SignedArea(std::span<const Point> ring) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) twice += Cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return 0.5 * twice;
}

double Length(std::span<const Point> polyline) {
  double length = 0;
  for (std::size_t i = 1; i < polyline.size(); ++i) length += Distance(polyline[i - 1], polyline[i]);
  return length;
}

Winding WindingNumber(std::span<const Point> ring, Point p) {
  Winding winding;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    if (OnSegment(a, b, p)) return {0, true};
    if (a.y <= p.y && b.y > p.y && Orientation(a, b, p) > 0) ++winding.number;
    if (a.y > p.y && b.y <= p.y && Orientation(a, b, p) < 0) --winding.number;
  }
  return winding;
}

bool ContainsPoint(std::span<const Point> ring, Point p) {
  const Winding winding = WindingNumber(ring, p);
  return winding.on_boundary || winding.number != 0;
}

bool StrictlyInside(const PolygonWithHoles& polygon, Point p) {
  const Winding outer = WindingNumber(polygon.outer, p);
  if (outer.on_boundary || outer.number == 0) return false;
  return std::none_of(polygon.holes.begin(), polygon.holes.end(),
                      [p](const Ring& hole) { return ContainsPoint(hole, p); });
}

Point InteriorPoint(const PolygonWithHoles& polygon) {
  const Point centroid = Centroid(polygon.outer);
  if (StrictlyInside(polygon, centroid)) return centroid;
  std::vector<double> ys;
  for (const Point p : polygon.outer) ys.push_back(p.y);
  for (const Ring& hole : polygon.holes) {
    for (const Point p : hole) ys.push_back(p.y);
  }
  std::sort(ys.begin(), ys.end());
  ys.erase(std::unique(ys.begin(), ys.end()), ys.end());
  std::pair<Point, double> best{polygon.outer[0], -1};
  for (std::size_t i = 0; i + 1 < ys.size(); ++i) {
    const auto candidate = LongestInterval(polygon, 0.5 * (ys[i] + ys[i + 1]));
    if (candidate.second > best.second && StrictlyInside(polygon, candidate.first)) best = candidate;
  }
  return best.first;
}

Point NearestOnSegment(Point p, Point a, Point b) {
  const Point ab = b - a;
  const double squared = Dot(ab, ab);
  if (squared == 0) return a;
  const double t = Dot(p - a, ab) / squared;
  if (t <= 0) return a;
  return t >= 1 ? b : Lerp(a, b, t);
}

double DistanceToSegment(Point p, Point a, Point b) { return Distance(p, NearestOnSegment(p, a, b)); }

Ring DropStraight(std::span<const Point> ring) {
  Ring distinct;
  std::unique_copy(ring.begin(), ring.end(), std::back_inserter(distinct));
  while (distinct.size() > 1 && distinct.front() == distinct.back()) distinct.pop_back();
  const std::size_t n = distinct.size();
  Ring kept;
  for (std::size_t i = 0; i < n; ++i) {
    const Point before = distinct[(i + n - 1) % n], p = distinct[i], after = distinct[(i + 1) % n];
    if (Orientation(before, p, after) != 0 || Dot(p - before, after - p) <= 0) kept.push_back(p);
  }
  return kept;
}

Ring DropCollinear(std::span<const Point> ring) {
  Ring kept;
  for (const Point p : ring) {
    if (!kept.empty() && kept.back() == p) continue;
    while (kept.size() >= 2 && Orientation(kept[kept.size() - 2], kept.back(), p) == 0) kept.pop_back();
    if (kept.empty() || kept.back() != p) kept.push_back(p);
  }
  // Around the seam, what is dropped may make its neighbours droppable.
  std::size_t first = 0;
  for (;;) {
    const std::size_t count = kept.size() - first;
    const bool repeated = count >= 2 && kept[first] == kept.back();
    if (repeated || (count >= 3 && Orientation(kept[kept.size() - 2], kept.back(), kept[first]) == 0)) {
      kept.pop_back();
    } else if (count >= 3 && Orientation(kept.back(), kept[first], kept[first + 1]) == 0) {
      ++first;
    } else {
      break;
    }
  }
  kept.erase(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(first));
  return kept;
}

}  // namespace tautline
