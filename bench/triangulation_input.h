// What the triangulation of a world starts from.
#ifndef TAUTLINE_BENCH_TRIANGULATION_INPUT_H_
#define TAUTLINE_BENCH_TRIANGULATION_INPUT_H_

#include <cstdint>
#include <vector>

#include "tautline/geometry/triangulation.h"
#include "tautline/scene/scene.h"

namespace tautline {

struct TriangulationInput {
  std::vector<Point> points;
  std::vector<InputEdge> edges;

  void AddRing(const Ring& ring) {
    const auto first = static_cast<std::int32_t>(points.size()), count = static_cast<std::int32_t>(ring.size());
    points.insert(points.end(), ring.begin(), ring.end());
    for (std::int32_t i = 0; i < count; ++i) edges.emplace_back(first + i, first + (i + 1) % count);
  }
};

/// The points and edges of the world's outline and obstacles. Requires simple polygons without holes.
inline TriangulationInput InputOf(const World& world) {
  TriangulationInput input;
  input.AddRing(world.outline);
  for (const Obstacle& obstacle : world.obstacles) input.AddRing(obstacle.polygon->outer);
  return input;
}

}  // namespace tautline

#endif  // TAUTLINE_BENCH_TRIANGULATION_INPUT_H_
