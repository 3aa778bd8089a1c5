#include "bench/free_points.h"

namespace tautline {

std::vector<Point> RandomFreePoints(Rng& rng, const TautSpace& space, std::size_t count) {
  const FreeSpace& ground = space.free_space();
  // The components stand largest first.
  const FreeComponent& largest = ground.components.at(0);
  std::vector<Point> points;
  while (points.size() < count) {
    const Point p{rng.Uniform(ground.box.low.x, ground.box.high.x), rng.Uniform(ground.box.low.y, ground.box.high.y)};
    const auto place = space.Locate(p);
    // Cheap tests first: most maps are half blocked, and few free points lie in a smaller component.
    if (!place || place->point != p || !ContainsPoint(largest.outer.points, p)) continue;
    if (ComponentOf(ground, p) == 0) points.push_back(p);
  }
  return points;
}

}  // namespace tautline
