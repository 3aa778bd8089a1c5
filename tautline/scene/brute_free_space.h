// Free space by looking at everything: the slow oracle of BuildFreeSpace, for tests and fuzzing.
#ifndef TAUTLINE_SCENE_BRUTE_FREE_SPACE_H_
#define TAUTLINE_SCENE_BRUTE_FREE_SPACE_H_

#include <algorithm>
#include <vector>

#include "tautline/base/check.h"
#include "tautline/geometry/polygon.h"
#include "tautline/scene/free_space.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// The outline and every ring of every polygon. O(n).
inline std::vector<Ring> PolygonRings(const World& world) {
  std::vector<Ring> rings{world.outline};
  for (const Obstacle& obstacle : world.obstacles) {
    if (!obstacle.polygon) continue;
    rings.push_back(obstacle.polygon->outer);
    rings.insert(rings.end(), obstacle.polygon->holes.begin(), obstacle.polygon->holes.end());
  }
  return rings;
}

/// Whether p lies outside of the outline or on or in a polygon. O(n).
inline bool InBlockedPolygon(const World& world, Point p) {
  if (!ContainsPoint(world.outline, p)) return true;
  return std::any_of(world.obstacles.begin(), world.obstacles.end(), [p](const Obstacle& obstacle) {
    if (!obstacle.polygon || !ContainsPoint(obstacle.polygon->outer, p)) return false;
    return std::none_of(obstacle.polygon->holes.begin(), obstacle.polygon->holes.end(), [p](const Ring& hole) {
      const Winding winding = WindingNumber(hole, p);
      return !winding.on_boundary && winding.number != 0;
    });
  });
}

/// The distance from p to what a world blocks before growth, by looking at everything: to its straight parts and to
/// its discs, of which the greatest radius is at `radius`.
struct BlockedDistance {
  double straight = 1e300;
  double disc = 1e300;  ///< Negative inside.
  double radius = 0;    ///< Of the nearest disc.
};

/// Those distances. O(n).
inline BlockedDistance DistanceToBlocked(const World& world, Point p) {
  BlockedDistance distance;
  for (const Ring& ring : PolygonRings(world)) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      distance.straight = std::min(distance.straight, DistanceToSegment(p, ring[i], ring[(i + 1) % ring.size()]));
    }
  }
  if (InBlockedPolygon(world, p)) distance.straight = -distance.straight;
  for (const Obstacle& obstacle : world.obstacles) {
    if (!obstacle.circle) continue;
    distance.disc = std::min(distance.disc, Distance(p, obstacle.circle->centre) - obstacle.circle->radius);
    distance.radius = std::max(distance.radius, obstacle.circle->radius);
  }
  return distance;
}

/// In how many components p lies strictly, 0 or 1; on a boundary the number has no meaning. O(n).
inline int FreeCount(const FreeSpace& space, Point p) {
  int sum = 0;
  for (const FreeComponent& component : space.components) {
    int winding = WindingNumber(component.outer.points, p).number;
    for (const BoundaryRing& hole : component.holes) winding += WindingNumber(hole.points, p).number;
    TAUTLINE_CHECK(winding == 0 || winding == 1);
    sum += winding;
  }
  return sum;
}

}  // namespace tautline

#endif  // TAUTLINE_SCENE_BRUTE_FREE_SPACE_H_
