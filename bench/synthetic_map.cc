#include "bench/synthetic_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "tautline/base/rng.h"

namespace tautline {
namespace {

constexpr double kCell = 10;  // Metres.

/// A ring around `centre` that meets every ray from it once, none of its points farther away than `radius`.
Ring JaggedStar(Rng& rng, Point centre, double radius, std::size_t count) {
  Ring ring;
  for (std::size_t i = 0; i < count; ++i) {
    // Less than half a turn apart, so that the ring winds around its centre even when it is a triangle.
    const double angle =
        (static_cast<double>(i) + rng.Uniform(0, 0.45)) / static_cast<double>(count) * 2 * std::numbers::pi;
    ring.push_back(centre + radius * rng.Uniform(0.4, 1) * Point{std::cos(angle), std::sin(angle)});
  }
  return ring;
}

}  // namespace

World SyntheticMap(const SyntheticMapOptions& options) {
  Rng rng(options.seed);
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(options.obstacles))));
  const double width = kCell * static_cast<double>(side);
  World world;
  world.outline = {{0, 0}, {width, 0}, {width, width}, {0, width}};
  for (std::size_t k = 0; k < options.obstacles; ++k) {
    const std::size_t first = k * options.vertices / options.obstacles;
    const std::size_t count = (k + 1) * options.vertices / options.obstacles - first;
    const double radius = rng.Uniform(0.25, 0.48) * kCell, slack = 0.49 * kCell - radius;
    const Point middle{(static_cast<double>(k % side) + 0.5) * kCell, (static_cast<double>(k / side) + 0.5) * kCell};
    const Point centre = middle + Point{rng.Uniform(-slack, slack), rng.Uniform(-slack, slack)};
    Obstacle obstacle;
    obstacle.name = "o" + std::to_string(k + 1);
    obstacle.polygon = PolygonWithHoles{JaggedStar(rng, centre, radius, std::max<std::size_t>(3, count)), {}};
    world.obstacles.push_back(std::move(obstacle));
  }
  return world;
}

SyntheticCorridor MakeSyntheticCorridor(std::size_t vertices, std::uint64_t seed) {
  Rng rng(seed);
  SyntheticCorridor corridor;
  const std::size_t steps = std::max<std::size_t>(2, vertices / 2);
  Polyline upper;
  for (std::size_t i = 0; i < steps; ++i) {
    const Point middle{2 * static_cast<double>(i), rng.Uniform(-3, 3)};
    corridor.way.push_back(middle);
    corridor.world.outline.push_back(middle - Point{0, 0.5});
    upper.push_back(middle + Point{0, 0.5});
  }
  corridor.world.outline.insert(corridor.world.outline.end(), upper.rbegin(), upper.rend());
  return corridor;
}

}  // namespace tautline
