#include "tautline/scene/ring_check.h"

#include <cmath>
#include <cstddef>

#include "tautline/geometry/self_crossing.h"

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

void CheckRing(const Ring& ring, const std::string& what, Position at, FieldReader& reader) {
  if (const auto pair = FindSelfCrossing(ring)) {
    return reader.Fail(at, what + " crosses itself: edge " + EdgeText(ring, pair->first) + " meets edge " +
                               EdgeText(ring, pair->second) + "; list the points in order around it");
  }
  if (!HasArea(ring)) reader.Fail(at, what + " has no area: its points lie on a line");
}

}  // namespace tautline
