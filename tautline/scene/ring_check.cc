#include "tautline/scene/ring_check.h"

#include <cmath>
#include <cstddef>

#include "tautline/geometry/ring_index.h"
#include "tautline/geometry/self_crossing.h"
#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

/// Below this share of the squared size of a ring its area is rounding error.
constexpr double kAreaTolerance = 1e-13;

std::string EdgeText(const Ring& ring, std::size_t edge) {
  return std::to_string(edge + 1) + " " + ToText(ring[edge]) + "-" + ToText(ring[(edge + 1) % ring.size()]);
}

}  // namespace

Ring WithoutRepeats(std::span<const Point> points) {
  Ring kept;
  for (const Point p : points) {
    if (kept.empty() || kept.back() != p) kept.push_back(p);
  }
  while (kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
  return kept;
}

bool HasArea(const Ring& ring) {
  const Point size = BoundingBox(ring).size();
  return ring.size() >= 3 && std::fabs(SignedArea(ring)) > kAreaTolerance * Dot(size, size);
}

std::optional<Fault> RingPointsFault(const Ring& ring) {
  if (ring.size() < 3) return Fault{" has " + std::to_string(ring.size()) + " points: it needs 3 or more"};
  return PointsFault(ring);
}

std::optional<Fault> RingFault(const Ring& ring) {
  if (auto fault = RingPointsFault(ring)) return fault;
  const Ring clean = WithoutRepeats(ring);
  if (const auto pair = FindSelfCrossing(clean)) {
    return Fault{" crosses itself: edge " + EdgeText(clean, pair->first) + " meets edge " +
                 EdgeText(clean, pair->second) + "; list the points in order around it"};
  }
  if (!HasArea(clean)) return Fault{" has no area: its points lie on a line"};
  return std::nullopt;
}

std::optional<Fault> HolesFault(const PolygonWithHoles& polygon) {
  if (polygon.holes.empty()) return std::nullopt;
  const RingIndex outer(polygon.outer);
  for (const Ring& hole : polygon.holes) {
    for (const Point p : hole) {
      const Winding winding = outer.WindingAt(p);
      if (winding.on_boundary || winding.number != 0) continue;
      return Fault{" hole does not lie inside the polygon, at " + ToText(p) + ": move it or leave it out"};
    }
    for (std::size_t i = 0; i < hole.size(); ++i) {
      if (!outer.IsCrossedBy(hole[i], hole[(i + 1) % hole.size()])) continue;
      return Fault{" hole leaves the polygon on its edge " + EdgeText(hole, i) + ": move it or leave it out"};
    }
  }
  return std::nullopt;
}

std::optional<Fault> CircleFault(const Circle& circle) {
  if (const auto fault = PositiveFault(circle.radius)) return Fault{" radius" + fault->text, fault->code};
  const Point reach{circle.radius, circle.radius};
  for (const Point p : {circle.centre, circle.centre - reach, circle.centre + reach}) {
    if (auto fault = PointFault(p)) return Fault{" reaches a point that" + fault->text, fault->code};
  }
  return std::nullopt;
}

std::optional<Fault> ShapeCountFault(bool has_polygon, bool has_circle) {
  if (has_polygon != has_circle) return std::nullopt;
  return Fault{" must have exactly one of 'polygon' and 'circle'"};
}

std::optional<Fault> RepresentativeFault(const Obstacle& obstacle) {
  if (!obstacle.representative) return std::nullopt;
  const Point p = *obstacle.representative;
  if (auto fault = PointFault(p)) return fault;
  const bool inside = obstacle.polygon ? StrictlyInside(*obstacle.polygon, p)
                                       : Distance(obstacle.circle->centre, p) < obstacle.circle->radius;
  if (inside) return std::nullopt;
  return Fault{" " + ToText(p) + " does not lie strictly inside the obstacle: move it or leave it out"};
}

}  // namespace tautline
