#include "tautline/planners/tether/prepared_check.h"

#include <cmath>

#include "tautline/base/check.h"
#include "tautline/scene/number_fault.h"

namespace tautline {
namespace {

/// Products of four differences of coordinates must not vanish: predicates are exact only above.
constexpr double kLeastGrid = 1e-60;
/// Integers up to here are doubles exactly.
constexpr double kLargestInteger = 0x1p53;

bool IsSize(double value) { return std::isfinite(value) && value >= 0; }

bool IsPoint(Point p) { return std::fabs(p.x) <= 2 * kLargestCoordinate && std::fabs(p.y) <= 2 * kLargestCoordinate; }

bool IsOnGrid(double value, double grid) {
  const double steps = std::nearbyint(value / grid);
  return std::fabs(steps) <= kLargestInteger && steps * grid == value;
}

void CheckRing(const BoundaryRing& ring, const FreeSpace& space) {
  TAUTLINE_CHECK(ring.points.size() >= 3);
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    const Point p = ring.points[i];
    TAUTLINE_CHECK(IsPoint(p) && IsOnGrid(p.x, space.grid) && IsOnGrid(p.y, space.grid));
    TAUTLINE_CHECK(space.box.low.x <= p.x && p.x <= space.box.high.x);
    TAUTLINE_CHECK(space.box.low.y <= p.y && p.y <= space.box.high.y);
    TAUTLINE_CHECK(p != ring.points[(i + 1) % ring.points.size()]);
  }
  TAUTLINE_CHECK(!ring.obstacle.valid() || ring.obstacle.index() < space.islands.size());
}

}  // namespace

void CheckPreparedSpace(const FreeSpace& space) {
  TAUTLINE_CHECK(space.grid >= kLeastGrid && space.grid <= kLargestCoordinate);
  TAUTLINE_CHECK(IsSize(space.clearance) && IsSize(space.snap));
  TAUTLINE_CHECK(IsPoint(space.box.low) && IsPoint(space.box.high));
  TAUTLINE_CHECK(!space.components.empty());
  for (const FreeComponent& component : space.components) {
    TAUTLINE_CHECK(IsSize(component.area));
    CheckRing(component.outer, space);
    for (const BoundaryRing& hole : component.holes) CheckRing(hole, space);
  }
  for (const Island& island : space.islands) TAUTLINE_CHECK(IsPoint(island.representative) && IsSize(island.area));
  for (const Snap& snap : space.snaps) TAUTLINE_CHECK(IsPoint(snap.from) && IsPoint(snap.to));
}

void CheckPreparedSight(const SightList& sight) {
  std::size_t begin = 0;
  for (std::size_t c = 0; c < sight.counts.size(); ++c) {
    TAUTLINE_CHECK(sight.counts[c] >= 0);
    const auto count = static_cast<std::size_t>(sight.counts[c]);
    TAUTLINE_CHECK(count <= sight.sightings.size() - begin);
    for (std::size_t k = begin; k < begin + count; ++k) {
      const Sighting& seen = sight.sightings[k];
      TAUTLINE_CHECK(seen.corner.valid() && seen.corner.index() < sight.counts.size() && seen.corner.index() != c);
      for (const Side side : {seen.tail, seen.head}) TAUTLINE_CHECK(side == Side::kLeft || side == Side::kRight);
      TAUTLINE_CHECK(k == begin || sight.sightings[k - 1] < seen);
    }
    begin += count;
  }
  TAUTLINE_CHECK(begin == sight.sightings.size());
}

}  // namespace tautline
