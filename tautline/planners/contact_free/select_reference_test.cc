#include "tautline/planners/contact_free/select_reference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tautline/base/test_scale.h"
#include "tautline/homotopy/classes.h"
#include "tautline/homotopy/sketched_scene.h"
#include "tautline/planners/contact_free/random_robot_ground.h"

namespace tautline {
namespace {

TEST(Waypoints, AreNoFartherApartThanTheSpacing) {
  EXPECT_EQ(Waypoints({{0, 0}, {1, 0}, {1, 0.4}}, 0.5), (Polyline{{0.5, 0}, {1, 0}, {1, 0.4}}));
  EXPECT_EQ(Waypoints({{0, 0}}, 0.5), Polyline{});
  EXPECT_EQ(Waypoints({{0, 0}, {1.01, 0}}, 0.5).size(), 3U);
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

TautGround GroundOf(const SketchedScene& sketch, double radius) {
  return PrepareRobotGround(sketch.world, radius).value();
}

TEST(SelectReference, TakesTheShortestPathWhenTheCableIsLong) {
  const auto sketch = Wall();
  const TautGround ground = GroundOf(sketch, 0);
  const auto result = SelectReference(ground, {{sketch['B']}, 100, sketch['G']}, {.list = 2});
  ASSERT_EQ(result.outcome, ReferenceOutcome::kFound);
  EXPECT_EQ(result.reference->path, (Polyline{sketch['B'], {3, 6}, {4, 6}, sketch['G']}));
  EXPECT_DOUBLE_EQ(result.reference->tether_length_m, result.reference->length_m);
  ASSERT_EQ(result.candidates.size(), 2U);
  EXPECT_TRUE(result.candidates[0].fits && result.candidates[1].fits);
  EXPECT_FALSE(result.all_listed);
}

TEST(SelectReference, GoesRoundTheOtherWayWhereTheCableIsShort) {
  const auto sketch = Wall();
  const TautGround ground = GroundOf(sketch, 0);
  // Laid under the wall: the way straight on needs 9.06 m of cable, that back and over the wall 4.5 m.
  const Polyline laid{sketch['B'], sketch['U'], sketch['V'], sketch['G']};
  const Point goal{4.5, 6.5};
  const auto free = SelectReference(ground, {laid, 100, goal}, {.list = 3});
  ASSERT_TRUE(free.reference);
  EXPECT_TRUE(free.reference->word.empty());
  // With 8 m the cable as laid is too long already.
  for (const double length : {8.5, 8.0}) {
    const auto tight = SelectReference(ground, {laid, length, goal}, {.list = 3});
    ASSERT_TRUE(tight.reference);
    EXPECT_EQ(ToString(tight.reference->word, ground.space().rays().names()), "w");
    EXPECT_FALSE(tight.candidates[0].fits);
    EXPECT_EQ(tight.reference->path, (Polyline{sketch['G'], {4, 2}, {3, 2}, {3, 6}, goal}));
    EXPECT_NEAR(tight.reference->tether_length_m, std::hypot(2.5, 1.5) + std::hypot(1.5, 0.5), 1e-12);
  }
}

TEST(SelectReference, SaysWhyThereIsNone) {
  const auto sketch = Sketch({"..w....", "..w..pp", "B.w..pG", "..w..pp", "..w...."});
  const TautGround ground = GroundOf(sketch, 0.25);
  EXPECT_EQ(SelectReference(ground, {{sketch['B']}, 100, {2.5, 2.5}}).outcome, ReferenceOutcome::kGoalBlocked);
  const auto apart = SelectReference(ground, {{sketch['B']}, 100, {4, 2.5}});
  EXPECT_EQ(apart.outcome, ReferenceOutcome::kGoalUnreachable);
  EXPECT_NE(apart.explanation.find("choose another goal"), std::string::npos);
  EXPECT_EQ(SelectReference(ground, {{{2.5, 2.5}}, 100, {4, 2.5}}).outcome, ReferenceOutcome::kStartBlocked);
  const auto wall = Wall();
  const TautGround open = GroundOf(wall, 0.25);
  const auto shortest = SelectReference(open, {{wall['B']}, 7, wall['G']});
  EXPECT_EQ(shortest.outcome, ReferenceOutcome::kTetherTooShort);
  ASSERT_TRUE(shortest.shortest_tether);
  EXPECT_GT(shortest.shortest_tether->length, 7);
  EXPECT_NE(shortest.explanation.find("choose another goal"), std::string::npos);
  EXPECT_TRUE(SelectReference(open, {{wall['B']}, shortest.shortest_tether->length, wall['G']}).reference);
}

TEST(SelectReference, LeavesASocket) {
  const auto sketch = Wall();
  const TautGround ground = GroundOf(sketch, 0.4);
  const Point base{0.1, 4.5};
  const auto result = SelectReference(ground, {{base}, 100, sketch['G']});
  ASSERT_TRUE(result.reference);
  EXPECT_EQ(result.reference->path.front(), base);
  EXPECT_NEAR(result.reference->length_m, Length(result.reference->path), 1e-12);
  EXPECT_NEAR(result.reference->tether_length_m, result.reference->length_m, 1e-12);
  // A robot that has drawn its cable out of the socket.
  const auto out = SelectReference(ground, {{base, {1, 4.5}}, 100, sketch['G']});
  ASSERT_TRUE(out.reference);
  EXPECT_EQ(out.reference->path.front(), (Point{1, 4.5}));
  EXPECT_NEAR(out.reference->tether_length_m, result.reference->tether_length_m, 1e-12);
}

// A cable that has slid over the corner of an obstacle still has its class.
TEST(SelectReference, ReadsTheClassOfACableThatHasSlid) {
  const auto sketch = Wall();
  const TautGround ground = GroundOf(sketch, 0.4);
  const Polyline slid{sketch['B'], {3.5, 5.9}, {5, 6.3}, {6, 5}};
  ASSERT_TRUE(Shorten(ground.space(), slid).departure);
  const auto result = SelectReference(ground, {slid, 100, sketch['G']});
  ASSERT_TRUE(result.reference);
  EXPECT_EQ(ToString(result.reference->tether_word, ground.space().rays().names()), "w");
  const auto clean = SelectReference(ground, {{sketch['B'], {3.5, 6.5}, {6, 5}}, 100, sketch['G']});
  EXPECT_EQ(result.reference->path, clean.reference->path);
  EXPECT_NEAR(result.reference->tether_length_m, clean.reference->tether_length_m, 1e-12);
}

/// The least length over all classes from the end of `laid` whose tether fits, by trying them in order: infinite where
/// the shortest `most` do not. Nothing where the oracle cannot tell.
std::optional<double> BruteReference(ClassOracle& oracle, const ReferenceTask& task, int most) {
  const auto node = [&oracle](Point p) { return oracle.sight().NodesAt(p)[0]; };
  const std::size_t base = node(task.laid.front()), robot = node(task.laid.back()), goal = node(task.goal);
  double least = std::numeric_limits<double>::infinity();
  int seen = 0;
  const bool enough = oracle.Run({.start = {robot},
                                  .word = oracle.AppendPolyline(0, task.laid),
                                  .remaining = oracle.DistancesTo(std::vector{goal}),
                                  .limit = 1e300,
                                  .allowed = {}},
                                 [&](const ClassOracle::State& state) {
                                   if (state.node != goal) return true;
                                   const double tether = oracle.LengthOf(base, goal, state.word, task.cable_length_m);
                                   if (tether <= task.cable_length_m) least = state.length;
                                   return ++seen < most && !std::isfinite(least);
                                 });
  if (!enough && !std::isfinite(least) && seen < most) return std::nullopt;
  return least;
}

TEST(SelectReference, AgreesWithTryingAllClasses) {
  Rng rng(821);
  int found = 0, bound = 0;
  for (std::int64_t trial = 0; trial < ScaledTestCount(150); ++trial) {
    SCOPED_TRACE(trial);
    const RandomScene scene = MakeRandomScene(rng, false);
    const Point base = RandomFreePoint(rng, scene), robot = RandomFreePoint(rng, scene);
    const Point goal = RandomFreePoint(rng, scene);
    ClassOracle oracle(scene.rings, scene.representatives, std::vector{base, robot, goal});
    const auto node = [&oracle](Point p) { return oracle.sight().NodesAt(p)[0]; };
    const auto laid = RandomWalk(rng, oracle, node(base), node(robot), 4);
    if (!laid) continue;
    const TautGround ground = PrepareRobotGround(scene.world, 0).value();
    const double least = oracle.DistancesTo(std::vector{node(goal)})[node(base)];
    if (!std::isfinite(least)) {
      EXPECT_EQ(SelectReference(ground, {*laid, 100, goal}).outcome, ReferenceOutcome::kGoalUnreachable);
      continue;
    }
    const ReferenceTask task{*laid, (least + 1e-6) * rng.Uniform(0.9, 1.6), goal};
    const auto brute = BruteReference(oracle, task, 60);
    const auto result = SelectReference(ground, task, {.list = 30});
    if (task.cable_length_m < least * (1 - 1e-9)) {
      EXPECT_EQ(result.outcome, ReferenceOutcome::kTetherTooShort);
      EXPECT_NEAR(result.shortest_tether->length, least, 1e-9);
      continue;
    }
    ASSERT_TRUE(result.reference) << result.explanation;
    if (!brute || !std::isfinite(*brute)) continue;
    EXPECT_NEAR(result.reference->length_m, *brute, 1e-9);
    EXPECT_LE(result.reference->tether_length_m, task.cable_length_m * (1 + 1e-9));
    EXPECT_EQ(result.reference->tether_word, ground.space().rays().WordOf(*laid) * result.reference->word);
    ++found;
    const auto first = std::find_if(result.candidates.begin(), result.candidates.end(),
                                    [](const ReferenceCandidate& candidate) { return candidate.fits; });
    if (first == result.candidates.end()) continue;
    EXPECT_NEAR(first->path.length, result.reference->length_m, 1e-9);
    if (first != result.candidates.begin()) ++bound;
  }
  EXPECT_GT(found, 0);
  EXPECT_GE(bound, ScaledTestCount(150) / 30);
}

}  // namespace
}  // namespace tautline
