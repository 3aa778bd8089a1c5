// Random questions about reach, and slow answers to them, for tests.
#ifndef TAUTLINE_PLANNERS_TETHER_RANDOM_REACH_H_
#define TAUTLINE_PLANNERS_TETHER_RANDOM_REACH_H_

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "tautline/homotopy/random_scene.h"
#include "tautline/homotopy/taut_space.h"
#include "tautline/planners/tether/region_ring.h"

namespace tautline {

/// A scene with a base, a length, points anywhere in the free ground, and the oracle that looks from all of them.
struct RandomReach {
  RandomScene ground;
  Point base;
  double length = 0;
  std::vector<Point> samples;
  ClassOracle oracle;

  std::vector<std::size_t> NodesAt(Point p) const { return oracle.sight().NodesAt(p); }

  /// The distances of points from the base by Dijkstra over the full visibility graph; infinite when not connected.
  std::vector<double> DistancesOf(const std::vector<Point>& points) const {
    const auto from_base = oracle.DistancesTo(NodesAt(base));
    std::vector<double> distances;
    for (const Point p : points) {
      double least = std::numeric_limits<double>::infinity();
      for (const std::size_t node : NodesAt(p)) least = std::min(least, from_base[node]);
      distances.push_back(least);
    }
    return distances;
  }
};

/// With `touching`, the base is often a vertex at which blocked ground touches.
inline RandomReach MakeRandomReach(Rng& rng, bool lattice, bool touching, int samples) {
  RandomScene ground = MakeRandomScene(rng, lattice);
  const Point base = touching ? RandomTouchingPoint(rng, ground) : RandomFreePoint(rng, ground);
  const double length = rng.UniformInt(0, 3) == 0 ? rng.UniformInt(1, 10) : rng.Uniform(0.3, 14);
  std::vector<Point> points{base};
  const Box box = BoundingBox(ground.world.outline);
  while (points.size() <= static_cast<std::size_t>(samples)) points.push_back(RandomPoint(rng, box));
  ClassOracle oracle(ground.rings, ground.representatives, points);
  points.erase(points.begin());
  return {std::move(ground), base, length, std::move(points), std::move(oracle)};
}

/// A ring with its arcs replaced by chords of at most `step` radians.
inline Ring Polygonised(const RegionRing& ring, double step) {
  Ring points;
  for (const RegionPiece& piece : ring.pieces) {
    points.push_back(piece.from);
    if (!piece.is_arc()) continue;
    const Point start = piece.from - piece.centre;
    const double low = std::atan2(start.y, start.x);
    const int count = static_cast<int>(std::ceil(piece.sweep / step));
    for (int i = 1; i < count; ++i) {
      const double angle = low + piece.sweep * i / count;
      points.push_back(piece.centre + piece.radius * Point{std::cos(angle), std::sin(angle)});
    }
  }
  return points;
}

/// How often the rings wind around p.
inline int WindingAround(const std::vector<RegionRing>& rings, Point p) {
  int number = 0;
  for (const RegionRing& ring : rings) {
    const Ring points = Polygonised(ring, 1e-2);
    if (points.size() >= 3) number += WindingNumber(points, p).number;
  }
  return number;
}

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_RANDOM_REACH_H_
