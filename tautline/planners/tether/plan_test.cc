#include "tautline/planners/tether/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/homotopy/sketched_scene.h"
#include "tautline/planners/tether/random_tether.h"
#include "tautline/planners/tether/reach.h"
#include "tautline/planners/tether/tether_planner.h"
#include "tautline/planners/tether/verify_plan.h"

namespace tautline {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Scene WithTether(const SketchedScene& sketch, double length, std::optional<Polyline> laid, Point goal) {
  Scene scene;
  scene.world = sketch.world;
  scene.tether = Tether{laid ? laid->front() : sketch['B'], length, laid};
  scene.goal = goal;
  return scene;
}

/// A wall with a way over it and a longer way under it; the base is on the left.
SketchedScene Wall() {
  return Sketch({".......",  //
                 "...w...",  //
                 "B..w..G",  //
                 "...w...",  //
                 "...w...",  //
                 ".......",  //
                 "U.....V"});
}

PlanResult PlanOf(const Scene& scene, const PlanOptions& options = {}) { return Plan(scene, options).value(); }

std::string ReasonOf(const Scene& scene) {
  const PlanResult result = PlanOf(scene);
  EXPECT_EQ(result.status, PlanStatus::kInfeasible);
  EXPECT_FALSE(result.motion);
  EXPECT_FALSE(result.explanation.empty());
  return ToString(result.obstruction);
}

TEST(Plan, TakesTheShortestWayWhenTheTetherIsLong) {
  const auto sketch = Wall();
  const PlanResult result = PlanOf(WithTether(sketch, 100, std::nullopt, sketch['G']));
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_EQ(result.obstruction, PlanObstruction::kNone);
  EXPECT_EQ(result.motion->path.points, (Polyline{sketch['B'], {3, 6}, {4, 6}, sketch['G']}));
  EXPECT_EQ(result.motion->tether.points, result.motion->path.points);
  EXPECT_FALSE(result.rejected);
  EXPECT_EQ(result.limit, 100);
  EXPECT_EQ(result.start.points, (Polyline{sketch['B']}));
}

TEST(Plan, UnwindsATetherThatIsTooShortForTheDirectWay) {
  const auto sketch = Wall();
  // Laid over the wall; the goal is just below, on the robot's side. The direct way would wrap the wall.
  const Polyline laid{sketch['B'], {0.5, 6.5}, {6.5, 6.5}, sketch['V']};
  const double over = std::hypot(2.5, 1.5) + 1 + std::hypot(2.5, 5.5);
  const Scene scene = WithTether(sketch, over + 0.1, laid, sketch['U']);
  const PlanResult result = PlanOf(scene);
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_NEAR(result.start.length, over, 1e-12);
  EXPECT_EQ(result.start.points, (Polyline{sketch['B'], {3, 6}, {4, 6}, sketch['V']}));
  ASSERT_TRUE(result.rejected);
  EXPECT_EQ(result.rejected->path.points, (Polyline{sketch['V'], sketch['U']}));
  EXPECT_GT(result.rejected->tether.length, result.limit);
  EXPECT_EQ(result.motion->path.points, (Polyline{sketch['V'], {4, 6}, {3, 6}, sketch['U']}));
  EXPECT_EQ(result.motion->tether.points, (Polyline{sketch['B'], sketch['U']}));
  EXPECT_TRUE(VerifyPlan(TetherPlanner::Prepare(scene.world).value(), *scene.tether, *scene.goal, result).ok());
}

TEST(Plan, NamesEachObstruction) {
  const auto sketch = Wall();
  const Point b = sketch['B'], g = sketch['G'], v = sketch['V'], in_wall{3.5, 3.5};
  EXPECT_EQ(ReasonOf(WithTether(sketch, 50, std::nullopt, in_wall)), "goal_blocked");
  EXPECT_EQ(ReasonOf(WithTether(sketch, 50, std::nullopt, {-1, 2})), "goal_blocked");
  EXPECT_EQ(ReasonOf(WithTether(sketch, 50, Polyline{in_wall}, g)), "start_blocked");
  EXPECT_EQ(ReasonOf(WithTether(sketch, 50, Polyline{b, {3, 3.5}, in_wall}, g)), "start_blocked");
  EXPECT_EQ(ReasonOf(WithTether(sketch, 50, Polyline{b, {0.5, 3}, g}, v)), "laid_cable_blocked");
  EXPECT_EQ(ReasonOf(WithTether(sketch, 5, Polyline{b, {3.5, 6.5}, g}, g)), "laid_cable_too_long");
  EXPECT_EQ(ReasonOf(WithTether(sketch, 5, std::nullopt, g)), "tether_too_short");
}

TEST(Plan, NamesAGoalThatIsCutOff) {
  const auto sketch = Sketch({"B.w.G",  //
                              "..w.."});
  EXPECT_EQ(ReasonOf(WithTether(sketch, 50, std::nullopt, sketch['G'])), "goal_unreachable");
}

TEST(Plan, TellsWhatTetherWouldDo) {
  const auto sketch = Wall();
  const PlanResult result = PlanOf(WithTether(sketch, 6.8, std::nullopt, sketch['G']));
  EXPECT_EQ(result.obstruction, PlanObstruction::kTetherTooShort);
  ASSERT_TRUE(result.shortest_tether);
  EXPECT_NEAR(result.shortest_tether->length, 2 * std::hypot(2.5, 1.5) + 1, 1e-12);
}

TEST(Plan, AllowsATetherThatFitsExactly) {
  const auto sketch = Wall();
  const double needed = 2 * std::hypot(2.5, 1.5) + 1;
  EXPECT_EQ(PlanOf(WithTether(sketch, needed, std::nullopt, sketch['G'])).status, PlanStatus::kSolved);
  EXPECT_EQ(PlanOf(WithTether(sketch, needed - 1e-6, std::nullopt, sketch['G'])).status, PlanStatus::kInfeasible);
}

TEST(Plan, StaysWhereTheGoalIs) {
  const auto sketch = Wall();
  const PlanResult result = PlanOf(WithTether(sketch, 20, Polyline{sketch['B'], {3.5, 6.5}, sketch['G']}, sketch['G']));
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_EQ(result.motion->path.length, 0);
  EXPECT_EQ(result.motion->tether.points, result.start.points);
}

TEST(Plan, CountsTheStubOfASocket) {
  auto sketch = Sketch({".......",  //
                        ".......",  //
                        ".......",  //
                        "......."});
  sketch.world.clearance = 0.5;
  const Point base{3, 0.25};
  Scene scene = WithTether(sketch, 2.5, Polyline{base}, {3, 2.75});
  const PlanResult result = PlanOf(scene);
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_NEAR(result.motion->tether.length, 2.5, 1e-9);
  EXPECT_NEAR(result.motion->path.length, 2.5, 1e-9);
  scene.tether->length = 2.4;
  EXPECT_EQ(ReasonOf(scene), "tether_too_short");
}

TEST(Plan, RefusesASceneWithoutAQuestion) {
  Scene scene = WithTether(Wall(), 10, std::nullopt, {1, 1});
  scene.goal.reset();
  EXPECT_FALSE(Plan(scene));
  scene = WithTether(Wall(), 10, std::nullopt, {1, 1});
  scene.tether.reset();
  EXPECT_FALSE(Plan(scene));
}

TEST(Plan, RefusesATetherThatCannotBe) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const Scene good = WithTether(Wall(), 10, Polyline{{1, 1}, {2, 1}}, {1, 1});
  const Point base = good.tether->base;
  std::vector<Scene> bad(8, good);
  bad[0].tether->length = kNan;
  bad[1].tether->length = kInfinity;
  bad[2].tether->length = -1;
  bad[3].tether->base.x = kNan;
  bad[4].goal->y = kInfinity;
  bad[5].tether->laid = Polyline{base, {kNan, 1}};
  bad[6].tether->laid = Polyline{base + Point{0.1, 0}, {2, 1}};
  bad[7].tether->laid = Polyline{};
  const auto planner = TetherPlanner::Prepare(good.world).value();
  for (std::size_t i = 0; i < bad.size(); ++i) {
    SCOPED_TRACE(i);
    const auto result = Plan(bad[i]);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().message.find(i == 4 ? "goal is" : "tether."), 0U) << result.error().message;
    EXPECT_THROW(static_cast<void>(planner.Plan(*bad[i].tether, *bad[i].goal)), std::logic_error);
    if (i == 4) continue;
    EXPECT_THROW(static_cast<void>(planner.PrepareStart(*bad[i].tether)), std::logic_error);
    EXPECT_THROW(static_cast<void>(Reach(planner, *bad[i].tether)), std::logic_error);
    EXPECT_FALSE(Reach(bad[i]));
  }
  EXPECT_THROW(static_cast<void>(planner.PrepareGoal(*bad[4].goal)), std::logic_error);
  EXPECT_FALSE(Reach(good, {.at = *bad[4].goal}));
}

TEST(Plan, StopsAtItsBudget) {
  const auto sketch = Wall();
  const Polyline laid{sketch['B'], {0.5, 6.5}, {6.5, 6.5}, sketch['V']};
  const PlanResult result = PlanOf(WithTether(sketch, 10, laid, sketch['U']), {.all = false, .budget = 1});
  EXPECT_EQ(result.status, PlanStatus::kBudgetExceeded);
  EXPECT_FALSE(result.motion);
}

class PlanRandom : public testing::TestWithParam<bool> {
 protected:
  /// Calls test(question, what the oracle says, rng) for `count` random questions.
  void ForEachTether(std::int64_t count, const std::function<void(RandomTether&, const OracleMotion&, Rng&)>& test) {
    for (std::int64_t seed = 0; seed < ScaledTestCount(count); ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Rng rng(static_cast<std::uint64_t>(seed));
      RandomTether question = MakeRandomTether(rng, GetParam());
      const OracleMotion expected = OraclePlan(question.oracle, question.query);
      if (!expected.too_many_states) test(question, expected, rng);
      if (HasFatalFailure()) return;
    }
  }
};

INSTANTIATE_TEST_SUITE_P(Families, PlanRandom, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "Lattice" : "Separated"; });

void ExpectLength(double length, double expected) {
  if (std::isinf(expected)) {
    ASSERT_TRUE(std::isinf(length)) << "found " << length << ", but there is none";
  } else {
    ASSERT_NEAR(length, expected, 1e-9 * (1 + expected));
  }
}

double LengthOf(const std::optional<Motion>& motion) { return motion ? motion->path.length : kInfinity; }

void ExpectObstruction(const PlanResult& result, const OracleMotion& expected) {
  switch (result.obstruction) {
    case PlanObstruction::kGoalUnreachable:
      EXPECT_TRUE(std::isinf(expected.unlimited));
      break;
    case PlanObstruction::kLaidCableTooLong:
      EXPECT_TRUE(std::isinf(expected.laid_length));
      break;
    case PlanObstruction::kTetherTooShort:
      EXPECT_TRUE(std::isinf(expected.shortest_tether) && std::isfinite(expected.unlimited));
      break;
    default:
      ADD_FAILURE() << "no plan because of '" << ToString(result.obstruction) << "'";
  }
}

TEST_P(PlanRandom, IsTheShortestMotionOfTheOracle) {
  ForEachTether(500, [](RandomTether& question, const OracleMotion& expected, Rng&) {
    // A motion between two configurations that fit has a tether that fits everywhere [Yang2022].
    ExpectLength(expected.checked, expected.unchecked);
    const Scene scene = question.scene();
    const auto planner = TetherPlanner::Prepare(scene.world).value();
    const PlanResult result = planner.Plan(*scene.tether, *scene.goal);
    ExpectLength(LengthOf(result.motion), expected.checked);
    if (result.motion) {
      ASSERT_EQ(result.status, PlanStatus::kSolved);
      ExpectLength(result.start.length, expected.laid_length);
      ExpectLength(result.rejected ? result.rejected->path.length : result.motion->path.length, expected.unlimited);
    } else {
      ASSERT_EQ(result.status, PlanStatus::kInfeasible);
      ExpectObstruction(result, expected);
    }
    const Verification verification = VerifyPlan(planner, *scene.tether, *scene.goal, result);
    EXPECT_TRUE(verification.ok()) << verification.faults[0];
  });
}

TEST_P(PlanRandom, ListsAllTethersThatFit) {
  ForEachTether(100, [](RandomTether& question, const OracleMotion&, Rng&) {
    const Scene scene = question.scene();
    const PlanResult result = PlanOf(scene, {.all = true, .max_all = 1'000'000});
    if (!result.motion) return;
    ASSERT_TRUE(result.all_complete);
    const auto tethers = question.oracle.Classes(scene.tether->base, *scene.goal, scene.tether->length);
    if (!tethers) return;
    ASSERT_EQ(result.all.size(), tethers->size());
    ExpectLength(result.all[0].path.length, result.motion->path.length);
    for (const Motion& motion : result.all) {
      const auto found = std::find_if(tethers->begin(), tethers->end(),
                                      [&](const OracleClass& c) { return c.word == motion.tether.word; });
      ASSERT_NE(found, tethers->end());
      ExpectLength(motion.tether.length, found->length);
      ASSERT_EQ(result.start.word * motion.path.word, motion.tether.word);
    }
  });
}

/// A question on a lattice whose base, robot and goal often stand where blocked ground touches.
std::optional<RandomTether> RandomTouchingTether(Rng& rng) {
  RandomScene ground = MakeRandomScene(rng, true);
  const Point base = RandomTouchingPoint(rng, ground), robot = RandomTouchingPoint(rng, ground);
  const Point goal = RandomTouchingPoint(rng, ground);
  ClassOracle oracle(ground.rings, ground.representatives, std::vector{base, robot, goal});
  const auto any_node = [&](Point p) {
    const auto nodes = oracle.sight().NodesAt(p);
    return nodes[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(nodes.size()) - 1))];
  };
  const std::size_t from = any_node(base), to = any_node(robot);
  const auto laid = RandomWalk(rng, oracle, from, to);
  if (!laid) return std::nullopt;
  OracleQuery query{*laid, goal, Length(*laid) * rng.Uniform(0.6, 1.1) + rng.Uniform(0, 3), {from}, {to}};
  if (from == to && oracle.AppendPolyline(0, *laid) == 0) {
    // Without a cable the robot may leave through any sector; a cable that was undone is nobody's question.
    if (laid->size() > 1) return std::nullopt;
    query.base_nodes = query.robot_nodes = {};
  }
  return RandomTether{std::move(ground), std::move(oracle), std::move(query)};
}

TEST(Plan, KeepsToItsSectorWhereObstaclesTouch) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(500); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    auto question = RandomTouchingTether(rng);
    if (!question) continue;
    const OracleMotion expected = OraclePlan(question->oracle, question->query);
    if (expected.too_many_states) continue;
    ExpectLength(expected.checked, expected.unchecked);
    const Scene scene = question->scene();
    const auto planner = TetherPlanner::Prepare(scene.world).value();
    const PlanResult result = planner.Plan(*scene.tether, *scene.goal, {.all = true, .max_all = 1'000'000});
    ExpectLength(LengthOf(result.motion), expected.checked);
    if (result.motion) {
      ExpectLength(result.all.at(0).path.length, expected.checked);
    }
    const Verification verification = VerifyPlan(planner, *scene.tether, *scene.goal, result);
    EXPECT_TRUE(verification.ok()) << verification.faults[0];
    if (HasFatalFailure()) return;
  }
}

/// The points of `path` up to a fraction of its length.
Polyline UpTo(const TautPath& path, double fraction) {
  Polyline points{path.points[0]};
  double left = fraction * path.length;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const double leg = Distance(path.points[i - 1], path.points[i]);
    if (leg >= left) {
      points.push_back(Lerp(path.points[i - 1], path.points[i], left / leg));
      break;
    }
    left -= leg;
    points.push_back(path.points[i]);
  }
  return points;
}

TEST_P(PlanRandom, FitsEverywhereAlongTheWay) {
  ForEachTether(200, [](RandomTether& question, const OracleMotion&, Rng& rng) {
    const Scene scene = question.scene();
    const PlanResult result = PlanOf(scene);
    if (!result.motion || result.motion->path.length == 0) return;
    const TautSpace space(question.ground.space);
    for (int k = 0; k < 20; ++k) {
      Polyline cable = *scene.tether->laid;
      const Polyline driven = UpTo(result.motion->path, rng.Uniform());
      cable.insert(cable.end(), driven.begin(), driven.end());
      const Shortened shortened = Shorten(space, cable);
      ASSERT_FALSE(shortened.departure);
      ASSERT_LE(shortened.path.length, result.limit + 1e-6);
    }
  });
}

/// The scene with every point moved.
Scene Moved(Scene scene, const std::function<Point(Point)>& map, double scale) {
  for (Point& p : scene.world.outline) p = map(p);
  for (Obstacle& obstacle : scene.world.obstacles) {
    for (Point& p : obstacle.polygon->outer) p = map(p);
  }
  scene.world.snap *= scale;
  scene.tether->base = map(scene.tether->base);
  scene.tether->length *= scale;
  for (Point& p : *scene.tether->laid) p = map(p);
  scene.goal = map(*scene.goal);
  return scene;
}

TEST_P(PlanRandom, IsAsLongInAMirroredTurnedAndScaledScene) {
  ForEachTether(100, [](RandomTether& question, const OracleMotion& expected, Rng& rng) {
    const Scene scene = question.scene();
    const double scale = std::exp2(rng.UniformInt(-10, 10));
    const auto mirrored = Moved(
        scene,
        [](Point p) {
          return Point{-p.x, p.y};
        },
        1);
    const auto turned = Moved(
        scene,
        [](Point p) {
          return Point{-p.y, p.x};
        },
        1);
    const auto scaled = Moved(
        scene, [scale](Point p) { return scale * p; }, scale);
    ExpectLength(LengthOf(PlanOf(mirrored).motion), expected.checked);
    ExpectLength(LengthOf(PlanOf(turned).motion), expected.checked);
    ExpectLength(LengthOf(PlanOf(scaled).motion) / scale, expected.checked);
  });
}

}  // namespace
}  // namespace tautline
