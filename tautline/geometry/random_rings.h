// Random polygons for tests: overlapping, touching, repeated, thin, with holes.
#ifndef TAUTLINE_GEOMETRY_RANDOM_RINGS_H_
#define TAUTLINE_GEOMETRY_RANDOM_RINGS_H_

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "tautline/base/rng.h"
#include "tautline/geometry/polygon.h"

namespace tautline {

inline Point RandomPoint(Rng& rng, const Box& box) {
  return {rng.Uniform(box.low.x, box.high.x), rng.Uniform(box.low.y, box.high.y)};
}

/// A box between a thousandth of a metre and a kilometre wide, sometimes far from the origin.
inline Box RandomBox(Rng& rng) {
  const double size = std::pow(10, rng.UniformInt(-3, 3));
  const double away = rng.UniformInt(0, 3) == 0 ? std::min(1e5 * size, 5e6) : 0;
  const Point low{rng.Uniform(-away, away), rng.Uniform(-away, away)};
  return {low, low + Point{size, size * rng.Uniform(0.5, 1)}};
}

inline Ring Rectangle(Point low, Point high) { return {low, {high.x, low.y}, high, {low.x, high.y}}; }

/// A simple ring that runs counter-clockwise around `centre` and meets every ray from it once.
inline Ring RandomStar(Rng& rng, Point centre, double radius) {
  const int count = rng.UniformInt(3, 9);
  Ring ring;
  for (int i = 0; i < count; ++i) {
    // Neighbours stay less than half a turn apart.
    const double angle = (i + rng.Uniform(0, 0.45)) / count * 2 * std::numbers::pi;
    ring.push_back(centre + rng.Uniform(0.2, 1) * radius * Point{std::cos(angle), std::sin(angle)});
  }
  return ring;
}

/// A triangle or a parallelogram between 1e-7 and 1 times as wide as it is long; counter-clockwise.
inline Ring RandomSliver(Rng& rng, const Box& box) {
  const Point a = RandomPoint(rng, box), b = RandomPoint(rng, box);
  const Point width = std::pow(10, rng.Uniform(-7, 0)) * Point{a.y - b.y, b.x - a.x};
  return rng.UniformInt(0, 1) == 0 ? Ring{a, b, b + width} : Ring{a, b, b + width, a + width};
}

/// A rectangle with corners on a lattice of 8 x 8 cells over the box; counter-clockwise.
inline Ring RandomLatticeRectangle(Rng& rng, const Box& box) {
  const Point cell = 0.125 * box.size();
  const auto interval = [&rng] {
    const int low = rng.UniformInt(0, 7);
    return std::pair(low, rng.UniformInt(low + 1, 8));
  };
  const auto [x0, x1] = interval();
  const auto [y0, y1] = interval();
  return Rectangle(box.low + Point{x0 * cell.x, y0 * cell.y}, box.low + Point{x1 * cell.x, y1 * cell.y});
}

/// The ring moved so that one of its vertices lies exactly on one of `other`.
inline Ring MovedToTouch(Rng& rng, const Ring& ring, const Ring& other) {
  const auto mine = static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(ring.size()) - 1));
  const Point target = other[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(other.size()) - 1))];
  Ring moved;
  for (const Point p : ring) moved.push_back(target + (p - ring[mine]));
  moved[mine] = target;
  return moved;
}

/// The ring turned by half a turn about the middle of one of its edges, which both then share exactly.
inline Ring TurnedAboutEdge(Rng& rng, const Ring& ring) {
  const auto i = static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(ring.size()) - 1));
  const std::size_t j = (i + 1) % ring.size();
  Ring turned;
  for (const Point p : ring) turned.push_back(ring[i] + (ring[j] - p));
  turned[i] = ring[j];
  turned[j] = ring[i];
  return turned;
}

/// A star; one time in three it has a hole of half its size.
inline PolygonWithHoles RandomStarWithHole(Rng& rng, const Box& box) {
  const Point centre = RandomPoint(rng, box);
  PolygonWithHoles polygon{RandomStar(rng, centre, box.size().x * rng.Uniform(0.02, 0.5)), {}};
  if (rng.UniformInt(0, 2) != 0) return polygon;
  Ring hole;
  for (const Point p : polygon.outer) hole.push_back(Lerp(centre, p, 0.5));
  polygon.holes.push_back(std::move(hole));
  return polygon;
}

/// One to eight simple polygons in and around the box that overlap, touch, share edges, repeat or are thin.
inline std::vector<PolygonWithHoles> RandomPolygons(Rng& rng, const Box& box) {
  std::vector<PolygonWithHoles> polygons;
  const int count = rng.UniformInt(1, 8);
  const auto any = [&]() -> const PolygonWithHoles& {
    return polygons[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(polygons.size()) - 1))];
  };
  while (polygons.size() < static_cast<std::size_t>(count)) {
    const int kind = rng.UniformInt(0, 9);
    if (kind <= 3 || polygons.empty()) {
      polygons.push_back(RandomStarWithHole(rng, box));
    } else if (kind == 4 || kind == 5) {
      polygons.push_back({RandomSliver(rng, box), {}});
    } else if (kind == 6) {
      polygons.push_back({RandomLatticeRectangle(rng, box), {}});
    } else if (kind == 7) {
      polygons.push_back(PolygonWithHoles(any()));
    } else if (kind == 8) {
      polygons.push_back({TurnedAboutEdge(rng, any().outer), {}});
    } else {
      polygons.push_back({MovedToTouch(rng, any().outer, any().outer), {}});
    }
  }
  return polygons;
}

/// A ring around the free ground of a test: the box, or a star in it; either orientation.
inline Ring RandomOutline(Rng& rng, const Box& box) {
  Ring outline =
      rng.UniformInt(0, 1) == 0 ? Rectangle(box.low, box.high) : RandomStar(rng, box.centre(), 0.7 * box.size().x);
  if (rng.UniformInt(0, 1) == 0) std::reverse(outline.begin(), outline.end());
  return outline;
}

}  // namespace tautline

#endif  // TAUTLINE_GEOMETRY_RANDOM_RINGS_H_
