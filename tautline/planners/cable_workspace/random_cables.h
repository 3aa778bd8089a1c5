// Random winches and laid cables for tests, in the random scenes of the engine.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_RANDOM_CABLES_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_RANDOM_CABLES_H_

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "tautline/homotopy/random_scene.h"
#include "tautline/planners/cable_workspace/boundary.h"

namespace tautline {

/// A scene with anchors in order around its largest free piece, and a cable from each to one robot.
struct RandomCables {
  RandomScene scene;
  CableGround ground;
  std::vector<Point> points;  ///< Where the anchors were asked to be.
  Anchors anchors;
  Point robot;
  std::vector<Polyline> laid;   ///< Robot first, anchor last.
  bool all_on_outline = false;  ///< Every anchor stands on the ring around the free piece.
};

namespace random_cables {

/// A point on a ring, and a node of the oracle from which it is reached in a straight line: itself where it lies
/// exactly on the ring.
struct RingPoint {
  std::size_t edge = 0;
  double share = 0;
  Point point;
  Point node;
};

inline constexpr double kInward = 1e-4;

inline RingPoint RandomRingPoint(Rng& rng, const Ring& ring) {
  const auto edge = static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(ring.size()) - 1));
  const Point a = ring[edge], b = ring[(edge + 1) % ring.size()];
  const int kind = rng.UniformInt(0, 9);
  if (kind < 4) return {edge, 0, a, a};
  if (kind < 7) return {edge, 0.5, Lerp(a, b, 0.5), Lerp(a, b, 0.5)};
  // Anywhere on the edge, off its line by rounding when that is slanted.
  const double share = rng.Uniform(0.05, 0.95);
  const Point p = Lerp(a, b, share);
  return {edge, share, p, p + (kInward / Distance(a, b)) * Point{a.y - b.y, b.x - a.x}};
}

/// Points around the outer ring in order, now and then one on an island between two of them.
inline std::vector<RingPoint> RandomAnchors(Rng& rng, const FreeComponent& component, bool& all_on_outline) {
  std::vector<RingPoint> anchors;
  const int count = rng.UniformInt(3, 6);
  for (int i = 0; i < count; ++i) anchors.push_back(RandomRingPoint(rng, component.outer.points));
  std::sort(anchors.begin(), anchors.end(), [](const RingPoint& a, const RingPoint& b) {
    return std::pair(a.edge, a.share) < std::pair(b.edge, b.share);
  });
  all_on_outline = true;
  for (RingPoint& anchor : anchors) {
    if (component.holes.empty() || rng.UniformInt(0, 9) > 0) continue;
    const auto hole = static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(component.holes.size()) - 1));
    anchor = RandomRingPoint(rng, component.holes[hole].points);
    all_on_outline = false;
  }
  if (rng.UniformInt(0, 1) == 0) std::reverse(anchors.begin(), anchors.end());
  return anchors;
}

/// The node of a point, if it has exactly one.
inline std::optional<std::size_t> OnlyNode(const ClassOracle& oracle, Point p) {
  const auto nodes = oracle.sight().NodesAt(p);
  if (nodes.size() != 1) return std::nullopt;
  return nodes[0];
}

inline std::optional<std::vector<Polyline>> RandomLaid(Rng& rng, const ClassOracle& oracle, Point robot,
                                                       const std::vector<RingPoint>& anchors) {
  const auto from = OnlyNode(oracle, robot);
  if (!from) return std::nullopt;
  const int detours = rng.UniformInt(0, 3);
  std::vector<Polyline> laid;
  for (const RingPoint& anchor : anchors) {
    const auto to = OnlyNode(oracle, anchor.node);
    if (!to) return std::nullopt;
    auto walk = RandomWalk(rng, oracle, *from, *to, detours);
    if (!walk) return std::nullopt;
    if (anchor.point != anchor.node) walk->push_back(anchor.point);
    laid.push_back(*std::move(walk));
  }
  return laid;
}

}  // namespace random_cables

/// Random cables in a scene of the family.
inline RandomCables MakeRandomCables(Rng& rng, bool lattice) {
  for (;;) {
    RandomScene scene = MakeRandomScene(rng, lattice);
    auto ground = CableGround::Prepare(scene.world);
    if (!ground) continue;
    bool all_on_outline = false;
    const auto chosen = random_cables::RandomAnchors(rng, scene.space.components[0], all_on_outline);
    std::vector<Point> points, looked_at;
    for (const auto& anchor : chosen) {
      points.push_back(anchor.point);
      looked_at.push_back(anchor.node);
    }
    auto anchors = PlaceAnchors(*ground, points);
    if (!anchors) continue;
    const Point robot = RandomFreePoint(rng, scene);
    looked_at.push_back(robot);
    const ClassOracle oracle(scene.rings, scene.representatives, looked_at);
    auto laid = random_cables::RandomLaid(rng, oracle, robot, chosen);
    if (!laid) continue;
    return {std::move(scene), *std::move(ground), std::move(points), *std::move(anchors), robot,
            *std::move(laid), all_on_outline};
  }
}

/// Random cables that make a valid boundary, and that.
struct RandomCableWorkspace {
  RandomCables cables;
  WorkspaceBoundary boundary;
};

inline RandomCableWorkspace MakeRandomCableWorkspace(Rng& rng, bool lattice) {
  for (;;) {
    RandomCables cables = MakeRandomCables(rng, lattice);
    auto boundary = BoundaryOfCables(cables.ground, cables.anchors, cables.laid);
    if (boundary) return {std::move(cables), *std::move(boundary)};
  }
}

/// A cable as it is laid from one anchor to the robot and on to another.
inline Polyline LaidBetween(const RandomCables& cables, std::size_t from, std::size_t to) {
  Polyline laid(cables.laid[from].rbegin(), cables.laid[from].rend());
  laid.insert(laid.end(), cables.laid[to].begin(), cables.laid[to].end());
  return laid;
}

/// The same world elsewhere: every point mapped.
template <class Map>
World MappedWorld(World world, Map map) {
  for (Point& p : world.outline) p = map(p);
  for (Obstacle& obstacle : world.obstacles) {
    for (Point& p : obstacle.polygon->outer) p = map(p);
  }
  return world;
}

/// The walk from one anchor to another along their laid cables.
inline Walk WalkByCables(const RandomCables& cables, std::size_t from, std::size_t to) {
  const auto walks = FollowCables(cables.ground, cables.anchors, cables.laid).value();
  const FreeMesh& mesh = cables.ground.space().mesh();
  Walk walk = Joined(mesh, walks[from], Reversed(walks[to]));
  TAUTLINE_CHECK(TurnInto(mesh, cables.anchors[to].exit.triangle, walk));
  return walk;
}

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_RANDOM_CABLES_H_
