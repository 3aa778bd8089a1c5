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
  const HAugmentedGraph graph(space);
  const ClassList list = FindClasses(space, from, to, {.max_length = max_length, .max_count = {}});
  ASSERT_TRUE(list.complete);
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

TEST(HAugmentedGraph, FindsTheClassesThatTheLibraryFinds) {
  const std::int64_t trials = ScaledTestCount(300);
  for (std::int64_t seed = 0; seed < trials; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng, false);
    const TautSpace space(scene.space);
    const Point from = RandomFreePoint(rng, scene), to = RandomFreePoint(rng, scene);
    const auto nearest = FindClasses(space, from, to, {.max_length = {}, .max_count = 1});
    if (nearest.classes.empty()) continue;
    // A little more than a round number, so that no class is exactly as long.
    ExpectSameClasses(space, from, to, nearest.classes[0].length * rng.Uniform(1, 1.8) + 1e-6);
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
  const HAugmentedGraph graph(space);
  const ClassList list =
      FindClasses(space, scene.tether.base, scene.goals[0], {.max_length = {}, .max_count = 50});
  const PeerClassList peer =
      graph.FindClasses(graph.Connect(scene.tether.base), graph.Connect(scene.goals[0]), {.max_count = 50});
  ASSERT_EQ(peer.classes.size(), 50U);
  for (std::size_t i = 0; i < 50; ++i) EXPECT_NEAR(peer.classes[i].length, list.classes[i].length, 1e-6);
}

void ExpectSameMotion(const TetherPlanner& planner, const HAugmentedGraph& graph, const TetherQuery& query) {
  const PlanResult result = planner.Plan(query.tether, query.goal);
  auto cover = graph.MakeCover(graph.Connect(query.tether.base), graph.Connect(query.goal),
                               {.max_length = query.tether.length * (1 + kTetherTolerance)});
  ASSERT_FALSE(cover.gave_up);
  const PeerMotion motion = graph.Plan(
      cover, {graph.Connect(query.tether.laid->back()), planner.space().rays().WordOf(*query.tether.laid)}, {});
  ASSERT_EQ(result.motion.has_value(), motion.length.has_value());
  if (motion.length) {
    EXPECT_NEAR(result.motion->path.length, *motion.length, 1e-9 * (1 + *motion.length));
  }
}

TEST(HAugmentedGraph, PlansAsTheLibraryDoesInRandomScenes) {
  const std::int64_t trials = ScaledTestCount(200);
  std::size_t asked = 0;
  for (std::int64_t seed = 0; seed < trials; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const TetherPlanner planner = TetherPlanner::Prepare(MakeRandomScene(rng, false).world).value();
    const HAugmentedGraph graph(planner.space());
    for (const TetherQuery& query : BindingTetherQueries(rng, planner.space(), {.places = 6, .count = 3})) {
      ExpectSameMotion(planner, graph, query);
      ++asked;
    }
  }
  EXPECT_GT(asked, static_cast<std::size_t>(trials) / 2);
}

TEST(HAugmentedGraph, PlansAsTheLibraryDoesOnBothMaps) {
  for (const char* name : {"maze", "mess"}) {
    const BenchScene scene = ReadCdt2025(name);
    const TetherPlanner planner = TetherPlanner::Prepare(scene.world).value();
    const HAugmentedGraph graph(planner.space());
    Rng rng(1);
    const auto queries = RandomTetherQueries(
        rng, planner.space(),
        {.base = scene.tether.base, .length = scene.tether.length, .places = 5, .count = 40});
    for (const TetherQuery& query : queries) ExpectSameMotion(planner, graph, query);
  }
}

}  // namespace
}  // namespace tautline
