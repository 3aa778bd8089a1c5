// Random questions to the tether planner, for tests.
#ifndef TAUTLINE_PLANNERS_TETHER_RANDOM_TETHER_H_
#define TAUTLINE_PLANNERS_TETHER_RANDOM_TETHER_H_

#include <cmath>
#include <optional>
#include <vector>

#include "tautline/homotopy/random_scene.h"
#include "tautline/planners/tether/plan_oracle.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// A scene with a tether that often binds, and its oracle.
struct RandomTether {
  RandomScene ground;
  ClassOracle oracle;
  OracleQuery query;

  Scene scene() const {
    Scene scene;
    scene.world = ground.world;
    scene.tether = Tether{query.laid.front(), query.limit, query.laid};
    scene.goal = query.goal;
    return scene;
  }
};

/// A length for the tether that often forbids the robot's shortest way. Nothing when the question is dull or the oracle
/// needs too many states to tell.
inline std::optional<double> RandomLimit(Rng& rng, ClassOracle& oracle, const Polyline& laid, Point goal) {
  const auto node = [&oracle](Point p) { return oracle.sight().NodesAt(p)[0]; };
  const std::size_t base = node(laid.front()), robot = node(laid.back()), target = node(goal);
  const int word = oracle.AppendPolyline(0, laid);
  const double laid_length = oracle.LengthOf(base, robot, word, Length(laid));
  const double to_goal = oracle.DistancesTo(std::vector{target})[base];
  if (!std::isfinite(laid_length)) return std::nullopt;
  const double needed = std::isfinite(to_goal) ? std::max(laid_length, to_goal) : laid_length;
  double enough = needed;
  oracle.Run({.start = {robot},
              .word = word,
              .remaining = oracle.DistancesTo(std::vector{target}),
              .limit = 1e300,
              .allowed = {}},
             [&](const ClassOracle::State& state) {
               if (state.node != target) return true;
               enough = oracle.LengthOf(base, target, state.word, laid_length + state.length);
               return false;
             });
  const bool binds = enough > 1.1 * needed;
  if (!std::isfinite(enough) || (!binds && rng.UniformInt(0, 3) > 0)) return std::nullopt;
  return needed * rng.Uniform(0.98, 1.1) + 1e-3 + std::max(0.0, enough - needed) * rng.Uniform(0, 1.1);
}

/// Base, robot, goal and waypoints anywhere in the free ground, and the cable laid along a random walk.
inline RandomTether MakeRandomTether(Rng& rng, bool lattice) {
  for (;;) {
    RandomScene ground = MakeRandomScene(rng, lattice);
    std::vector<Point> points;
    for (int i = 0; i < 5; ++i) points.push_back(RandomFreePoint(rng, ground));
    if (rng.UniformInt(0, 5) == 0) points[1] = points[0];
    ClassOracle oracle(ground.rings, ground.representatives, points);
    const auto node = [&oracle](Point p) { return oracle.sight().NodesAt(p)[0]; };
    const auto walk = RandomWalk(rng, oracle, node(points[0]), node(points[1]));
    if (!walk) continue;
    const auto limit = RandomLimit(rng, oracle, *walk, points[2]);
    if (limit) return {std::move(ground), std::move(oracle), {*walk, points[2], *limit, {}, {}}};
  }
}

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_RANDOM_TETHER_H_
