#include "tautline/planners/tether/crossing_free.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <string>
#include <vector>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/curve_crossing.h"
#include "tautline/geometry/predicates.h"
#include "tautline/homotopy/random_scene.h"
#include "tautline/homotopy/sketched_scene.h"
#include "tautline/planners/tether/random_tether.h"
#include "tautline/planners/tether/verify_plan.h"

namespace tautline {
namespace {

PlanResult PlanOf(const TetherPlanner& planner, const Scene& scene, bool crossing_free = true) {
  return planner.Plan(*scene.tether, *scene.goal, {.crossing_free = crossing_free});
}

/// Whether the end of a taut tether, moved by a little, passes over the base: where the two curves part, they enclose
/// it.
bool SweepsBase(const Polyline& before, const Polyline& after) {
  std::size_t n = 0;
  while (n < before.size() && n < after.size() && before[n] == after[n]) ++n;
  if (n < 2) return false;
  Ring loop(before.begin() + static_cast<std::ptrdiff_t>(n) - 1, before.end());
  loop.insert(loop.end(), after.rbegin(), after.rend() - static_cast<std::ptrdiff_t>(n));
  const Winding winding = WindingNumber(loop, before[0]);
  return !winding.on_boundary && winding.number != 0;
}

/// Whether the free end touches an earlier part of the cable, with the robot, or over the base, so that rounding alone
/// tells on which side of it.
bool TouchesItself(const Polyline& tether) {
  constexpr double kRounding = 1e-9;
  const std::size_t n = tether.size();
  if (n < 3) return false;
  if (DistanceToSegment(tether[0], tether[n - 2], tether[n - 1]) < kRounding) return true;
  for (std::size_t i = 0; i + 2 < n; ++i) {
    if (DistanceToSegment(tether.back(), tether[i], tether[i + 1]) < kRounding) return true;
  }
  return false;
}

/// Whether a robot that goes straight on from the end of its taut tether drives across an earlier part of it, rather
/// than along it.
bool DrivesAcross(const Polyline& tether, Point to) {
  constexpr double kRounding = 1e-9;
  for (std::size_t i = 0; i + 2 < tether.size(); ++i) {
    const Point a = tether[i], b = tether[i + 1];
    const double off = std::min(DistanceToSegment(tether.back(), a, b), DistanceToSegment(to, a, b));
    if (off > kRounding && CrossProperly(tether.back(), to, a, b)) return true;
  }
  return false;
}

/// Drives straight on in small steps and looks at the taut tether at each: whether it crosses itself anywhere, or is
/// too long, and whether the robot drove across it.
struct Simulation {
  const TetherPlanner& planner;
  const LaidCable& laid;
  double limit;
  int steps;

  bool Drive(Walk& walk, Polyline& tether, Point to) const {
    const Point from = walk.at;
    for (int k = 1; k <= steps; ++k) {
      std::optional<Walk> moved = walk;
      const Point leg[] = {k == steps ? to : Lerp(from, to, static_cast<double>(k) / steps)};
      if (planner.space().Follow(leg, moved)) return false;
      walk = *moved;
      const TautPath now = planner.TetherAlong(laid.socket, walk);
      if (now.length > limit * (1 + kLengthTolerance)) return false;
      const bool rounded = k < steps && TouchesItself(now.points);
      if (!rounded && FindCurveCrossing(now.points)) return false;
      if (SweepsBase(tether, now.points) || DrivesAcross(tether, now.points.back())) return false;
      tether = now.points;
    }
    return true;
  }
};

/// Whether the motion, driven in small steps, nowhere crosses.
bool DrivesFreely(const TetherPlanner& planner, const Scene& scene, const Polyline& path, int steps) {
  const LaidCable laid = planner.FollowLaidCable(*scene.tether).value();
  const Simulation simulation{planner, laid, scene.tether->length, steps};
  Walk walk = laid.walk;
  Polyline tether = planner.TetherAlong(laid.socket, walk).points;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (!simulation.Drive(walk, tether, path[i])) return false;
  }
  return true;
}

/// The shortest crossing-free motion by Dijkstra over (node, taut tether): the nodes are the corners of the ground, the
/// base, the robot and the goal, the edges are lines of sight, each driven in small steps. Infinite where every motion
/// is longer than `at_most`; nothing when there are too many states.
std::optional<double> BruteForce(const TetherPlanner& planner, const Scene& scene, const ClassOracle& oracle,
                                 double at_most) {
  constexpr std::size_t kMostStates = 400;
  struct State {
    double length;
    std::size_t node;
    Walk walk;
    Polyline tether;
  };
  const auto later = [](const State& a, const State& b) { return a.length > b.length; };
  std::priority_queue<State, std::vector<State>, decltype(later)> queue(later);
  const LaidCable laid = planner.FollowLaidCable(*scene.tether).value();
  const Simulation simulation{planner, laid, scene.tether->length, 40};
  const std::vector<std::size_t> goals = oracle.sight().NodesAt(*scene.goal);
  const std::vector<double> remaining = oracle.DistancesTo(goals);
  const std::size_t start = oracle.sight().NodesAt(laid.walk.at).at(0);
  queue.push({0, start, laid.walk, planner.TetherAlong(laid.socket, laid.walk).points});
  std::map<Polyline, double> settled;
  while (!queue.empty()) {
    const State state = queue.top();
    queue.pop();
    if (!settled.emplace(state.tether, state.length).second) continue;
    if (settled.size() > kMostStates) return std::nullopt;
    if (state.node == goals.at(0)) return state.length;
    for (const std::size_t next : oracle.NeighboursOf(state.node)) {
      const Point to = oracle.sight().nodes()[next].point;
      const double length = state.length + Distance(state.walk.at, to);
      if (length + remaining[next] > at_most) continue;
      State moved{length, next, state.walk, state.tether};
      if (simulation.Drive(moved.walk, moved.tether, to)) queue.push(std::move(moved));
    }
  }
  return std::numeric_limits<double>::infinity();
}

/// A square in the middle, the cable nearly all around it, and the robot on the near side of its first part.
///
/// The robot is led around the square to a place beside the base. The goal is on the other side of the cable's first
/// part: the direct way crosses it.
SketchedScene Pillar() {
  return Sketch({".........",  //
                 ".........",  //
                 "...www...",  //
                 "...www...",  //
                 "...www...",  //
                 ".R.......",  //
                 "....B....",  //
                 ".G......."});
}

Scene WithLaid(const SketchedScene& sketch, double length, const Polyline& laid, Point goal) {
  Scene scene;
  scene.world = sketch.world;
  scene.tether = Tether{laid.front(), length, laid};
  scene.goal = goal;
  return scene;
}

TEST(CrossingFree, TakesTheShortestMotionWhereNothingCrosses) {
  const auto sketch = Pillar();
  const Scene scene = WithLaid(sketch, 30, {sketch['B'], sketch['R']}, sketch['G']);
  const auto planner = TetherPlanner::Prepare(scene.world).value();
  const PlanResult result = PlanOf(planner, scene), plain = PlanOf(planner, scene, false);
  ASSERT_TRUE(result.crossing_free);
  EXPECT_EQ(result.motion->path.points, plain.motion->path.points);
  EXPECT_TRUE(result.crossing_free->optimal);
  EXPECT_EQ(result.crossing_free->classes_examined, 1);
  EXPECT_EQ(result.crossing_free->bound, result.motion->path.length);
  EXPECT_FALSE(result.crossing_free->plain);
  EXPECT_FALSE(plain.crossing_free);
}

/// The scene of scenes/loop.yaml: the cable lies once around a yard and comes back to its base, robot and goal are on
/// the two sides of its first part.
Scene Loop() {
  Scene scene;
  scene.world.outline = {{-1, 0}, {8, 0}, {8, 10}, {-1, 10}};
  const Ring shelf{{0.5, 1}, {1.5, 1}, {1.5, 8}, {0.5, 8}}, crate{{3, 7}, {5, 7}, {5, 9}, {3, 9}};
  for (const Ring& ring : {shelf, crate}) {
    Obstacle obstacle;
    obstacle.name = "o" + std::to_string(scene.world.obstacles.size());
    obstacle.polygon = PolygonWithHoles{ring, {}};
    scene.world.obstacles.push_back(obstacle);
  }
  scene.tether =
      Tether{{4, 4}, 26, Polyline{{4, 4}, {1.5, 0.5}, {0, 1}, {0, 8}, {3, 9.5}, {5.5, 9}, {5.5, 7}, {2.5, 3}}};
  scene.goal = Point{4.9, 3};
  return scene;
}

TEST(CrossingFree, DrivesAroundTheBaseWhereTheTetherWouldBePulledOverIt) {
  const Scene scene = Loop();
  const auto planner = TetherPlanner::Prepare(scene.world).value();
  const PlanResult result = PlanOf(planner, scene);
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_EQ(result.motion->path.points, (Polyline{{2.5, 3}, {4, 4}, {4.9, 3}}));
  EXPECT_TRUE(result.crossing_free->around_base);
  EXPECT_TRUE(result.crossing_free->optimal);
  ASSERT_TRUE(result.crossing_free->plain);
  EXPECT_EQ(result.crossing_free->plain->path.points, (Polyline{{2.5, 3}, {4.9, 3}}));
  EXPECT_NEAR(result.crossing_free->retreat_length, std::hypot(2.5, 4) + std::hypot(0.1, 4), 1e-12);
  EXPECT_TRUE(DrivesFreely(planner, scene, result.motion->path.points, 200));
  EXPECT_FALSE(DrivesFreely(planner, scene, result.crossing_free->plain->path.points, 200));
  const Verification verification = VerifyPlan(planner, *scene.tether, *scene.goal, result);
  EXPECT_TRUE(verification.ok()) << verification.faults[0];
  PlanResult wrong = result;
  *wrong.motion = *result.crossing_free->plain;
  EXPECT_FALSE(VerifyPlan(planner, *scene.tether, *scene.goal, wrong).ok());
}

/// Left and right exchanged.
Scene Mirrored(Scene scene) {
  const auto mirror = [](Point& p) { p.x = -p.x; };
  const auto mirror_all = [&](auto& points) { std::for_each(points.begin(), points.end(), mirror); };
  mirror_all(scene.world.outline);
  for (Obstacle& obstacle : scene.world.obstacles) {
    if (obstacle.polygon) mirror_all(obstacle.polygon->outer);
  }
  mirror(scene.tether->base);
  mirror_all(*scene.tether->laid);
  mirror(*scene.goal);
  return scene;
}

/// That the plan holds on its own, and that its mirrored question has the mirrored answer.
void ExpectSound(const TetherPlanner& planner, const Scene& scene, const PlanResult& result) {
  EXPECT_TRUE(result.crossing_free->optimal);
  const double length = result.motion->path.length;
  EXPECT_LE(length, result.crossing_free->retreat_length * (1 + 1e-9));
  const Verification verification = VerifyPlan(planner, *scene.tether, *scene.goal, result);
  EXPECT_TRUE(verification.ok()) << verification.faults[0];
  EXPECT_TRUE(DrivesFreely(planner, scene, result.motion->path.points, 100));
  const Scene mirrored = Mirrored(scene);
  const PlanResult other = PlanOf(TetherPlanner::Prepare(mirrored.world).value(), mirrored);
  ASSERT_EQ(other.status, PlanStatus::kSolved);
  EXPECT_NEAR(other.motion->path.length, length, 1e-9 * (1 + length));
}

TEST(CrossingFree, RefusesACableThatCrossesItself) {
  const auto sketch = Pillar();
  const Polyline laid{sketch['B'], {7.5, 2}, {7.5, 7.5}, {1, 7.5}, {1.5, 3}, {4.5, 1.2}, {8.5, 2.5}};
  const Scene scene = WithLaid(sketch, 60, laid, sketch['G']);
  const auto planner = TetherPlanner::Prepare(scene.world).value();
  const PlanResult result = PlanOf(planner, scene);
  EXPECT_EQ(result.status, PlanStatus::kInfeasible);
  EXPECT_EQ(ToString(result.obstruction), "must_cross");
  EXPECT_NE(result.explanation.find("crosses itself at ("), std::string::npos);
  EXPECT_FALSE(result.motion);
  EXPECT_TRUE(VerifyPlan(planner, *scene.tether, *scene.goal, result).ok());
  EXPECT_EQ(PlanOf(planner, scene, false).status, PlanStatus::kSolved);
}

/// A random question with tether to spare.
Scene RandomQuestion(Rng& rng, const RandomTether& random) {
  Scene scene = random.scene();
  scene.tether->length *= rng.Uniform(1, 1.6);
  return scene;
}

/// The loop with base, robot and goal anywhere below the crate.
Scene RandomLoop(Rng& rng) {
  Scene scene = Loop();
  const auto place = [&rng] { return Point{rng.Uniform(1.8, 7.5), rng.Uniform(0.5, 6.5)}; };
  scene.tether->base = scene.tether->laid->front() = place();
  scene.tether->laid->back() = place();
  scene.tether->length = 40;
  scene.goal = place();
  return scene;
}

struct Tally {
  int crossed = 0, around = 0, compared = 0, refused = 0;
};

/// Plans without crossings, and compares with brute force where the shortest way crosses.
void ExpectAsBruteForce(const Scene& scene, const ClassOracle& oracle, Tally& tally) {
  const auto planner = TetherPlanner::Prepare(scene.world).value();
  const PlanResult result = PlanOf(planner, scene);
  if (result.obstruction == PlanObstruction::kMustCross) {
    ++tally.refused;
    EXPECT_TRUE(FindCurveCrossing(result.start.points));
  }
  if (result.status != PlanStatus::kSolved) return;
  ExpectSound(planner, scene, result);
  if (!result.crossing_free->plain) return;
  ++tally.crossed;
  tally.around += result.crossing_free->around_base ? 1 : 0;
  EXPECT_FALSE(DrivesFreely(planner, scene, result.crossing_free->plain->path.points, 400));
  const double length = result.motion->path.length;
  const auto brute = BruteForce(planner, scene, oracle, length + 1e-6);
  if (!brute) return;
  ++tally.compared;
  EXPECT_NEAR(*brute, length, 1e-6);
}

TEST(CrossingFree, IsWhatBruteForceFinds) {
  Tally tally;
  const std::int64_t count = ScaledTestCount(300);
  for (std::int64_t seed = 0; seed < count; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomTether random = MakeRandomTether(rng, false);
    ExpectAsBruteForce(RandomQuestion(rng, random), random.oracle, tally);
    ASSERT_FALSE(HasFailure());
  }
  if (count >= 300) {
    EXPECT_GT(tally.compared, 8);
    EXPECT_GT(tally.refused, 5);
  }
}

TEST(CrossingFree, IsWhatBruteForceFindsAroundTheBase) {
  Tally tally;
  const std::int64_t count = ScaledTestCount(150);
  for (std::int64_t seed = 0; seed < count; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const Scene scene = RandomLoop(rng);
    const std::vector<Ring> rings = RingsOf(scene.world);
    const std::vector<Point> representatives{{1, 4}, {4, 8}},
        points{scene.tether->base, scene.tether->laid->back(), *scene.goal};
    ExpectAsBruteForce(scene, ClassOracle(rings, representatives, points), tally);
    ASSERT_FALSE(HasFailure());
  }
  if (count >= 150) {
    EXPECT_GT(tally.around, 5);
    EXPECT_GT(tally.compared, 10);
  }
}

/// Where corners, bases and cables lie on each other.
TEST(CrossingFree, HoldsOnTheLattice) {
  int solved = 0;
  const std::int64_t count = ScaledTestCount(300);
  for (std::int64_t seed = 0; seed < count; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomTether random = MakeRandomTether(rng, true);
    const Scene scene = RandomQuestion(rng, random);
    const auto planner = TetherPlanner::Prepare(scene.world).value();
    const PlanResult result = PlanOf(planner, scene);
    if (result.status != PlanStatus::kSolved) continue;
    ++solved;
    EXPECT_TRUE(result.crossing_free->optimal);
    const Verification verification = VerifyPlan(planner, *scene.tether, *scene.goal, result);
    EXPECT_TRUE(verification.ok()) << verification.faults[0];
    EXPECT_LE(result.motion->path.length, result.crossing_free->retreat_length * (1 + 1e-9));
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(solved, count / 4);
}

TEST(CrossingFree, SaysWhatItsBudgetLeavesOpen) {
  Scene scene = Loop();
  // The second class is not looked at.
  const auto planner = TetherPlanner::Prepare(scene.world).value();
  const PlanResult result = planner.Plan(*scene.tether, *scene.goal, {.crossing_free = true, .budget = 1});
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_LE(result.crossing_free->bound, result.motion->path.length);
  EXPECT_GE(result.crossing_free->bound, result.crossing_free->plain->path.length);
}

}  // namespace
}  // namespace tautline
