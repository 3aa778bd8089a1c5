// Random scenes for tests of the engine and the planners, in two families: obstacles that keep apart, and obstacles on
// an integer lattice that overlap, touch, and share lines and columns.
#ifndef TAUTLINE_HOMOTOPY_RANDOM_SCENE_H_
#define TAUTLINE_HOMOTOPY_RANDOM_SCENE_H_

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "tautline/base/check.h"
#include "tautline/base/rng.h"
#include "tautline/geometry/predicates.h"
#include "tautline/geometry/random_rings.h"
#include "tautline/homotopy/brute_sight.h"
#include "tautline/homotopy/class_oracle.h"
#include "tautline/homotopy/print_point.h"
#include "tautline/scene/free_space.h"

namespace tautline {

/// A world with what its oracle looks at.
struct RandomScene {
  World world;
  bool lattice = false;
  FreeSpace space;
  std::vector<Ring> rings;             ///< From the world itself, or from `space` on the lattice.
  std::vector<Point> representatives;  ///< By ObstacleId.
};

namespace random_scene {

inline constexpr Box kBox{{0, 0}, {16, 12}};

/// Coordinates on the fine grid are not changed by BuildFreeSpace, and neither are the middles of edges.
inline Point OnFineGrid(Point p) { return {std::round(p.x * 0x1p16) * 0x1p-16, std::round(p.y * 0x1p16) * 0x1p-16}; }

inline Obstacle PolygonObstacle(const World& world, Ring ring) {
  Obstacle obstacle;
  obstacle.name = "o" + std::to_string(world.obstacles.size() + 1);
  obstacle.polygon = PolygonWithHoles{std::move(ring), {}};
  return obstacle;
}

/// A U of the given size, turned and moved.
inline Ring RandomHook(Rng& rng, Point centre, double size) {
  const double wall = rng.Uniform(0.05, 0.3), angle = rng.Uniform(0, 2 * std::numbers::pi), left = rng.Uniform(0.3, 1);
  Ring hook;
  for (const Point p : {Point{-1, -1},
                        {1, -1},
                        {1, 1},
                        {1 - wall, 1},
                        {1 - wall, wall - 1},
                        {wall - 1, wall - 1},
                        {wall - 1, left},
                        {-1, left}}) {
    hook.push_back(centre + 0.7 * size *
                                Point{std::cos(angle) * p.x - std::sin(angle) * p.y,
                                      std::sin(angle) * p.x + std::cos(angle) * p.y});
  }
  return hook;
}

inline Ring RandomObstacleRing(Rng& rng) {
  const Point centre = RandomPoint(rng, kBox);
  const int kind = rng.UniformInt(0, 9);
  Ring ring;
  if (kind <= 4) {
    ring = RandomStar(rng, centre, rng.Uniform(0.5, 5));
  } else if (kind <= 6) {
    ring = RandomHook(rng, centre, rng.Uniform(1, 4));
  } else if (kind == 7) {
    ring = RandomStar(rng, centre, rng.Uniform(0.01, 0.1));
  } else {
    const Point a = RandomPoint(rng, kBox), b = RandomPoint(rng, kBox);
    const Point width = rng.Uniform(0.01, 0.1) * Point{a.y - b.y, b.x - a.x};
    ring = {a, b, b + width};
  }
  for (Point& p : ring) p = OnFineGrid(p);
  return DropCollinear(ring);
}

inline bool IsSimple(const Ring& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const Point a = ring[i], b = ring[(i + 1) % n], c = ring[j], d = ring[(j + 1) % n];
      if (CrossProperly(a, b, c, d)) return false;
      if (j != i && j != (i + 1) % n && OnSegment(a, b, c)) return false;
    }
  }
  return n >= 3;
}

/// Whether the rings keep a distance that is far above the snap tolerance.
inline bool KeepApart(const Ring& one, const Ring& other) {
  constexpr double kApart = 1e-3;
  for (std::size_t i = 0; i < one.size(); ++i) {
    for (std::size_t j = 0; j < other.size(); ++j) {
      const Point a = one[i], b = one[(i + 1) % one.size()], c = other[j], d = other[(j + 1) % other.size()];
      if (CrossProperly(a, b, c, d) || DistanceToSegment(a, c, d) < kApart || DistanceToSegment(c, a, b) < kApart) {
        return false;
      }
    }
  }
  return true;
}

inline Ring RandomRoom(Rng& rng) {
  Ring outline = Rectangle(kBox.low, kBox.high);
  if (rng.UniformInt(0, 2) == 0) {
    outline = RandomStar(rng, kBox.centre(), 12);
    for (Point& p : outline) p = OnFineGrid(p);
  }
  if (rng.UniformInt(0, 1) == 0) std::reverse(outline.begin(), outline.end());
  return DropCollinear(outline);
}

inline World SeparatedWorld(Rng& rng) {
  World world;
  do {
    world.outline = RandomRoom(rng);
  } while (!IsSimple(world.outline));
  std::vector<Ring> rings{world.outline};
  const auto wanted = static_cast<std::size_t>(rng.UniformInt(1, 6));
  for (int attempt = 0; attempt < 60 && world.obstacles.size() < wanted; ++attempt) {
    Ring ring = RandomObstacleRing(rng);
    if (!IsSimple(ring) || !ContainsPoint(world.outline, ring[0])) continue;
    // None of the rings may hold the other's first vertex, but for the outline.
    const bool apart = std::all_of(rings.begin(), rings.end(), [&](const Ring& other) {
      const bool nested = &other != &rings[0] && (ContainsPoint(other, ring[0]) || ContainsPoint(ring, other[0]));
      return !nested && KeepApart(ring, other);
    });
    if (!apart) continue;
    rings.push_back(ring);
    world.obstacles.push_back(PolygonObstacle(world, std::move(ring)));
  }
  return world;
}

inline Point LatticePoint(Rng& rng) {
  return {static_cast<double>(rng.UniformInt(0, 10)), static_cast<double>(rng.UniformInt(0, 8))};
}

/// A rectangle, a triangle or a quadrangle with corners on the lattice, of positive area.
inline Ring RandomLatticeRing(Rng& rng) {
  for (;;) {
    const Point a = LatticePoint(rng);
    Ring ring;
    if (rng.UniformInt(0, 2) > 0) {
      ring =
          Rectangle(a, a + Point{static_cast<double>(rng.UniformInt(1, 3)), static_cast<double>(rng.UniformInt(1, 3))});
    } else {
      const int corners = rng.UniformInt(3, 4);
      for (int i = 0; i < corners; ++i) {
        ring.push_back(a +
                       Point{static_cast<double>(rng.UniformInt(-2, 2)), static_cast<double>(rng.UniformInt(-2, 2))});
      }
      ring = DropCollinear(ring);
    }
    if (IsSimple(ring)) return ring;
  }
}

inline World LatticeWorld(Rng& rng) {
  World world;
  world.outline = Rectangle({0, 0}, {10, 8});
  if (rng.UniformInt(0, 3) == 0)
    world.outline = {{0, 0}, {4, 0}, {5, 2}, {6, 0}, {10, 0}, {10, 8}, {4, 8}, {4, 6}, {0, 8}};
  const int wanted = rng.UniformInt(1, 8);
  for (int i = 0; i < wanted; ++i) world.obstacles.push_back(PolygonObstacle(world, RandomLatticeRing(rng)));
  return world;
}

}  // namespace random_scene

/// A scene of the family, with at least some free ground.
inline RandomScene MakeRandomScene(Rng& rng, bool lattice) {
  for (;;) {
    RandomScene scene;
    scene.lattice = lattice;
    scene.world = lattice ? random_scene::LatticeWorld(rng) : random_scene::SeparatedWorld(rng);
    auto space = BuildFreeSpace(scene.world);
    if (!space) continue;
    scene.space = *std::move(space);
    scene.rings = lattice ? RingsOf(scene.space) : RingsOf(scene.world);
    for (const Island& island : scene.space.islands) scene.representatives.push_back(island.representative);
    return scene;
  }
}

inline RandomScene MakeRandomScene(Rng& rng) { return MakeRandomScene(rng, rng.UniformInt(0, 1) == 0); }

namespace random_scene {

inline Point RandomBoundaryVertex(Rng& rng, const RandomScene& scene) {
  const Ring& ring = scene.rings[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(scene.rings.size()) - 1))];
  return ring[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(ring.size()) - 1))];
}

inline Point RandomPlace(Rng& rng, const RandomScene& scene) {
  if (scene.lattice) {
    const Point p{0.5 * rng.UniformInt(0, 20), 0.5 * rng.UniformInt(0, 16)};
    return rng.UniformInt(0, 3) == 0 ? p + Point{rng.Uniform(-0.2, 0.2), rng.Uniform(-0.2, 0.2)} : p;
  }
  Point p = OnFineGrid(RandomPoint(rng, BoundingBox(scene.world.outline)));
  const int kind = rng.UniformInt(0, 9);
  if (kind == 0) return RandomBoundaryVertex(rng, scene);
  if (kind == 1) p.x = RandomBoundaryVertex(rng, scene).x;
  if (kind == 2 && !scene.representatives.empty()) p.x = scene.representatives[0].x;
  if (kind == 3) {
    const Ring& ring = scene.rings.back();
    return Lerp(ring[0], ring[1], 0.5);
  }
  return p;
}

}  // namespace random_scene

/// A point of the closed free space that lies in one free sector only: often on the boundary, on a ray's column, or
/// in line with other things.
inline Point RandomFreePoint(Rng& rng, const RandomScene& scene) {
  for (;;) {
    const Point p = random_scene::RandomPlace(rng, scene);
    if (BruteSight(scene.rings, std::vector{p}).NodesAt(p).size() == 1) return p;
  }
}

/// As RandomFreePoint, but one time in two a vertex where blocked ground touches, if there is one.
inline Point RandomTouchingPoint(Rng& rng, const RandomScene& scene) {
  const BruteSight sight(scene.rings, {});
  std::vector<Point> touching;
  for (const SightNode& node : sight.nodes()) {
    if (sight.NodesAt(node.point).size() > 1) touching.push_back(node.point);
  }
  if (touching.empty() || rng.UniformInt(0, 1) == 0) return RandomFreePoint(rng, scene);
  return touching[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(touching.size()) - 1))];
}

/// A random walk from one node to another along lines of sight, grazing and turning back as it likes, by up to
/// `detours` steps before it goes straight for its end. Nothing when there is no way.
inline std::optional<Polyline> RandomWalk(Rng& rng, const ClassOracle& oracle, std::size_t from, std::size_t to,
                                          int detours = 6) {
  const std::vector<std::size_t> target{to};
  const std::vector<double> distance = oracle.DistancesTo(target);
  if (!std::isfinite(distance[from])) return std::nullopt;
  const auto point = [&oracle](std::size_t node) { return oracle.sight().nodes()[node].point; };
  Polyline walk{point(from)};
  std::size_t at = from;
  for (int step = rng.UniformInt(0, detours); step > 0; --step) {
    const auto neighbours = oracle.NeighboursOf(at);
    at = neighbours[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(neighbours.size()) - 1))];
    walk.push_back(point(at));
  }
  while (at != to) {
    const auto neighbours = oracle.NeighboursOf(at);
    at = *std::min_element(neighbours.begin(), neighbours.end(), [&](std::size_t a, std::size_t b) {
      return Distance(point(at), point(a)) + distance[a] < Distance(point(at), point(b)) + distance[b];
    });
    walk.push_back(point(at));
  }
  return walk;
}

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_RANDOM_SCENE_H_
