#include "bench/peers/h_augmented_graph.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bench/bench_scene.h"
#include "bench/tether_queries.h"
#include "tautline/base/test_scale.h"
#include "tautline/homotopy/classes.h"
#include "tautline/homotopy/random_scene.h"
#include "tautline/planners/tether/tether_planner.h"

namespace tautline {
namespace {

void ExpectSameClasses(const TautSpace& space, Point from, Point to, double max_length) {
  const ClassList list = FindClasses(space, from, to, {.max_length = max_length, .max_count = {}});
  ASSERT_TRUE(list.complete);
  for (const SightLines lines : {SightLines::kAll, SightLines::kTangent, SightLines::kBitangents}) {
    const HAugmentedGraph graph(space, lines);
    for (const Guess guess : {Guess::kNothing, Guess::kStraight, Guess::kExact}) {
      const PeerClassList peer =
          graph.FindClasses(graph.Connect(from), graph.Connect(to), {.guess = guess, .max_length = max_length});
      ASSERT_FALSE(peer.gave_up);
      ASSERT_EQ(peer.classes.size(), list.classes.size());
      for (std::size_t i = 0; i < peer.classes.size(); ++i) {
        EXPECT_NEAR(peer.classes[i].length, list.classes[i].length, 1e-9 * (1 + max_length));
        EXPECT_NEAR(Length(peer.classes[i].points), peer.classes[i].length, 1e-9 * (1 + max_length));
        EXPECT_EQ(peer.classes[i].points.front(), from);
        EXPECT_EQ(peer.classes[i].points.back(), to);
      }
    }
  }
}

TEST(HAugmentedGraph, FindsTheClassesThatTheLibraryFinds) {
  const std::int64_t trials = ScaledTestCount(60);
  for (std::int64_t seed = 0; seed < trials; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng, false);
    const TautSpace space(scene.space);
    const Point from = RandomFreePoint(rng, scene), to = RandomFreePoint(rng, scene);
    // So few that Dijkstra can enumerate all words on the way; the limit between two classes, so that none is as long.
    const auto few = FindClasses(space, from, to, {.max_length = {}, .max_count = 6}).classes;
    if (few.size() < 2) continue;
    const std::size_t last = static_cast<std::size_t>(rng.UniformInt(1, static_cast<int>(few.size()) - 1));
    ExpectSameClasses(space, from, to, 0.5 * (few[last - 1].length + few[last].length));
  }
}

TEST(HAugmentedGraph, FindsTheClassesOnBothMaps) {
  for (const char* name : {"maze", "mess"}) {
    const BenchScene scene = ReadCdt2025(name);
    const TautSpace space(BuildFreeSpace(scene.world).value());
    ASSERT_FALSE(scene.goals.empty());
    for (const Point goal : scene.goals) ExpectSameClasses(space, scene.tether.base, goal, scene.tether.length);
  }
}

TEST(HAugmentedGraph, FindsTheShortestClasses) {
  const BenchScene scene = ReadCdt2025("maze");
  const TautSpace space(BuildFreeSpace(scene.world).value());
  const HAugmentedGraph graph(space, SightLines::kAll);
  const ClassList list = FindClasses(space, scene.tether.base, scene.goals[0], {.max_length = {}, .max_count = 50});
  const PeerClassList peer =
      graph.FindClasses(graph.Connect(scene.tether.base), graph.Connect(scene.goals[0]), {.max_count = 50});
  ASSERT_EQ(peer.classes.size(), 50U);
  for (std::size_t i = 0; i < 50; ++i) EXPECT_NEAR(peer.classes[i].length, list.classes[i].length, 1e-6);
}

/// Whether the peer answers, rather than gives up.
bool ExpectSameMotion(const TetherPlanner& planner, const HAugmentedGraph& graph, const TetherQuery& query) {
  const PlanResult result = planner.Plan(query.tether, query.goal);
  auto cover = graph.MakeCover(graph.Connect(query.tether.base), graph.Connect(query.goal),
                               {.max_length = query.tether.length * (1 + kLengthTolerance), .max_states = 300'000});
  if (cover.gave_up) return false;
  const PeerMotion motion = graph.Plan(
      cover, {graph.Connect(query.tether.laid->back()), planner.space().rays().WordOf(*query.tether.laid)}, {});
  EXPECT_EQ(result.motion.has_value(), motion.length.has_value());
  if (motion.length && result.motion) {
    EXPECT_NEAR(result.motion->path.length, *motion.length, 1e-9 * (1 + *motion.length));
  }
  return true;
}

TEST(HAugmentedGraph, PlansAsTheLibraryDoesInRandomScenes) {
  const std::int64_t trials = ScaledTestCount(100);
  std::size_t answered = 0;
  for (std::int64_t seed = 0; seed < trials; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const TetherPlanner planner = TetherPlanner::Prepare(MakeRandomScene(rng, false).world).value();
    const HAugmentedGraph graph(planner.space(), seed % 2 == 0 ? SightLines::kAll : SightLines::kTangent);
    for (const TetherQuery& query : BindingTetherQueries(rng, planner.space(), {.places = 6, .count = 3})) {
      if (ExpectSameMotion(planner, graph, query)) ++answered;
    }
  }
  EXPECT_GT(answered, static_cast<std::size_t>(trials) / 2);
}

TEST(HAugmentedGraph, PlansAsTheLibraryDoesOnBothMaps) {
  for (const char* name : {"maze", "mess"}) {
    const BenchScene scene = ReadCdt2025(name);
    const TetherPlanner planner = TetherPlanner::Prepare(scene.world).value();
    const HAugmentedGraph all(planner.space(), SightLines::kAll), tangent(planner.space(), SightLines::kTangent);
    Rng rng(1);
    const auto queries = RandomTetherQueries(
        rng, planner.space(), {.base = scene.tether.base, .length = scene.tether.length, .places = 5, .count = 40});
    for (const TetherQuery& query : queries) {
      EXPECT_TRUE(ExpectSameMotion(planner, all, query));
      EXPECT_TRUE(ExpectSameMotion(planner, tangent, query));
    }
  }
}

}  // namespace
}  // namespace tautline
