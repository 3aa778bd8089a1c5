#include "tautline/draw/blocked_parts.h"

#include <algorithm>
#include <cmath>

namespace tautline {
namespace {

template <class Visit>
void ForEachBoundaryEdge(const FreeSpace& space, Visit visit) {
  const auto visit_ring = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
  };
  for (const FreeComponent& component : space.components) {
    visit_ring(component.outer.points);
    for (const BoundaryRing& hole : component.holes) visit_ring(hole.points);
  }
}

/// Where the segment pq, from 0 to 1, crosses the boundary; with both ends, sorted.
std::vector<double> Crossings(const FreeSpace& space, Point p, Point q) {
  std::vector<double> crossings = {0, 1};
  ForEachBoundaryEdge(space, [&](Point a, Point b) {
    const double slope = Cross(q - p, b - a);
    if (slope == 0) return;
    const double along = Cross(a - p, b - a) / slope, across = Cross(a - p, q - p) / slope;
    if (along > 0 && along < 1 && across >= -1e-9 && across <= 1 + 1e-9) crossings.push_back(along);
  });
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

}  // namespace

std::vector<Polyline> BlockedParts(const FreeSpace& space, std::span<const Point> line) {
  const double extent = std::max(space.box.size().x, space.box.size().y);
  // Far below what a picture shows.
  const double tolerance = std::max(space.snap, 1e-7 * extent);
  std::vector<Polyline> parts;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point p = line[i - 1], q = line[i];
    const std::vector<double> crossings = Crossings(space, p, q);
    for (std::size_t j = 1; j < crossings.size(); ++j) {
      const Point from = Lerp(p, q, crossings[j - 1]), to = Lerp(p, q, crossings[j]);
      if (Distance(from, to) < tolerance || ComponentOf(space, Lerp(from, to, 0.5), tolerance)) continue;
      if (parts.empty() || Distance(parts.back().back(), from) > tolerance) parts.push_back({from});
      parts.back().push_back(to);
    }
  }
  return parts;
}

}  // namespace tautline
