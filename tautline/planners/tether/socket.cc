#include "tautline/planners/tether/socket.h"

#include <algorithm>
#include <vector>

namespace tautline {
namespace {

/// For every boundary edge of the grown free space its point nearest to the base, nearest first.
std::vector<Point> NearestExits(const FreeSpace& space, Point base) {
  std::vector<Point> exits;
  const auto add = [&](const BoundaryRing& ring) {
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
      exits.push_back(NearestOnSegment(base, ring.points[i], ring.points[(i + 1) % ring.points.size()]));
    }
  };
  for (const FreeComponent& component : space.components) {
    add(component.outer);
    for (const BoundaryRing& hole : component.holes) add(hole);
  }
  std::sort(exits.begin(), exits.end(),
            [base](Point a, Point b) { return std::pair(Distance(base, a), a) < std::pair(Distance(base, b), b); });
  return exits;
}

}  // namespace

std::optional<Socket> FindSocket(const TautSpace& space, const FreeMesh& ungrown, Point base) {
  if (const auto place = space.Locate(base)) return Socket{place->point, *place, 0};
  const auto start = ungrown.Locate(base, space.tolerance());
  if (!start) return std::nullopt;
  for (const Point exit : NearestExits(space.free_space(), base)) {
    Walk walk(*start);
    if (WalkStraight(ungrown, exit, walk)) continue;
    if (const auto place = space.Locate(exit)) return Socket{base, *place, Distance(base, place->point)};
  }
  return std::nullopt;
}

}  // namespace tautline
