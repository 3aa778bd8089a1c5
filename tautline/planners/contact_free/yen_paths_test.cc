#include "tautline/planners/contact_free/yen_paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tautline/base/test_scale.h"
#include "tautline/homotopy/classes.h"
#include "tautline/homotopy/sketched_scene.h"
#include "tautline/homotopy/word_path.h"
#include "tautline/planners/contact_free/line_of_sight.h"
#include "tautline/planners/contact_free/path_lattice.h"
#include "tautline/planners/contact_free/random_robot_ground.h"
#include "tautline/planners/contact_free/yen_reference.h"

namespace tautline {
namespace {

/// Columns times rows points, each joined to most of its eight neighbours.
PathGraph RandomGrid(Rng& rng, int columns, int rows) {
  std::vector<Point> points;
  std::vector<PathGraph::Edge> edges;
  const auto node = [columns](int x, int y) { return PathNodeId(y * columns + x); };
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      points.push_back({x + rng.Uniform(0, 0.01), y + rng.Uniform(0, 0.01)});
      for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1), std::pair(1, 1), std::pair(-1, 1)}) {
        if (x + dx < 0 || x + dx >= columns || y + dy >= rows || rng.UniformInt(0, 4) == 0) continue;
        edges.emplace_back(node(x, y), node(x + dx, y + dy));
      }
    }
  }
  return {std::move(points), std::move(edges)};
}

/// The lengths of all simple paths on from the last node of `path`, by trying every step.
void CountLengths(const PathGraph& graph, PathNodeId to, std::vector<PathNodeId>& path, double length,
                  std::vector<double>& lengths) {
  const PathNodeId at = path.back();
  if (at == to) {
    lengths.push_back(length);
    return;
  }
  for (const PathNodeId next : graph.Neighbours(at)) {
    if (std::find(path.begin(), path.end(), next) != path.end()) continue;
    path.push_back(next);
    CountLengths(graph, to, path, length + graph.Length(at, next), lengths);
    path.pop_back();
  }
}

TEST(YenPaths, FindsTheShortestOfAllSimplePaths) {
  Rng rng(811);
  int shortened = 0;
  for (std::int64_t trial = 0; trial < ScaledTestCount(150); ++trial) {
    SCOPED_TRACE(trial);
    const PathGraph graph = RandomGrid(rng, rng.UniformInt(2, 4), rng.UniformInt(2, 3));
    const PathNodeId from(0), to(graph.size() - 1);
    std::vector<PathNodeId> start{from};
    std::vector<double> lengths;
    CountLengths(graph, to, start, 0, lengths);
    std::sort(lengths.begin(), lengths.end());
    const int count = rng.UniformInt(1, 60);
    const auto paths = YenPaths(graph, {.from = from, .to = to, .count = count});
    ASSERT_EQ(paths.size(), std::min(lengths.size(), static_cast<std::size_t>(count)));
    if (paths.size() < lengths.size()) ++shortened;
    std::set<std::vector<PathNodeId>> different;
    for (std::size_t i = 0; i < paths.size(); ++i) {
      EXPECT_NEAR(paths[i].length, lengths[i], 1e-12);
      EXPECT_NEAR(paths[i].length, Length(graph.PointsOf(paths[i].nodes)), 1e-12);
      EXPECT_EQ(paths[i].nodes.front(), from);
      EXPECT_EQ(paths[i].nodes.back(), to);
      EXPECT_EQ(std::set(paths[i].nodes.begin(), paths[i].nodes.end()).size(), paths[i].nodes.size());
      different.insert(paths[i].nodes);
    }
    EXPECT_EQ(different.size(), paths.size());
  }
  EXPECT_GT(shortened, 0);
}

TEST(YenPaths, FindsNothingWhereNothingIs) {
  const PathGraph graph({{0, 0}, {1, 0}, {2, 0}}, {{PathNodeId(0), PathNodeId(1)}});
  EXPECT_TRUE(YenPaths(graph, {.from = PathNodeId(0), .to = PathNodeId(2)}).empty());
}

TEST(ShortenByLineOfSight, StaysInTheClass) {
  const auto sketch = Sketch({".......",  //
                              "...w...",  //
                              "A.....B"});
  const TautSpace space(SpaceOf(sketch));
  const Polyline over{sketch['A'], {0.5, 2.5}, {3.5, 2.5}, {6.5, 2.5}, sketch['B']};
  const Polyline shortened = ShortenByLineOfSight(space, over);
  // Straight from A to B would be free, and of another class.
  EXPECT_EQ(shortened.size(), 3U);
  EXPECT_LT(Length(shortened), Length(over));
  EXPECT_EQ(space.rays().WordOf(shortened), space.rays().WordOf(over));
  const Polyline under{sketch['A'], {3.5, 0.5}, sketch['B']};
  EXPECT_EQ(ShortenByLineOfSight(space, under), (Polyline{sketch['A'], sketch['B']}));
}

// Every signature of the lattice is a class of the engine, no shorter than its taut path; lengths after shortening lie
// between the taut path and the lattice's.
TEST(EnumerateSignatures, FindsClassesOfTheEngine) {
  Rng rng(812);
  std::size_t classes = 0, paths = 0;
  for (std::int64_t trial = 0; trial < 8 + ScaledTestCount(52); ++trial) {
    SCOPED_TRACE(trial);
    const RobotGround scene = MakeRobotGround(rng, rng.Uniform(0.1, 0.4));
    const TautSpace& space = scene.ground.space();
    const auto found = EnumerateSignatures(space, scene.from, scene.to, {.count = 120, .step_m = 0.8});
    ASSERT_TRUE(found);
    std::set<Word> words;
    double before = 0;
    for (const TautPath& path : *found) {
      EXPECT_TRUE(words.insert(path.word).second);
      EXPECT_GE(path.length, before);
      before = path.length;
      const Shortened taut = Shorten(space, path.points);
      ASSERT_FALSE(taut.departure);
      EXPECT_EQ(taut.path.word, path.word);
      EXPECT_LE(taut.path.length, path.length * (1 + 1e-12));
      const auto known = FindWordPath(space, *space.Locate(scene.from), *space.Locate(scene.to), path.word);
      ASSERT_TRUE(known);
      EXPECT_NEAR(known->length, taut.path.length, 1e-9);
      ++paths;
    }
    if (found->size() > 1) ++classes;
  }
  EXPECT_GT(paths, 0U);
  EXPECT_GT(classes, 0U);
}

TEST(SelectReferenceByYen, FindsNothingShorterThanTheEngine) {
  Rng rng(813);
  int both = 0;
  for (std::int64_t trial = 0; trial < ScaledTestCount(60); ++trial) {
    SCOPED_TRACE(trial);
    const RobotGround scene = MakeRobotGround(rng, 0.2);
    const auto base = RandomRobotPlace(rng, scene.ground.space(), scene.from);
    if (!base) continue;
    const auto taut = FindClasses(scene.ground.space(), *base, scene.from, {.max_count = 3});
    const TautPath& cable =
        taut.classes[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(taut.classes.size()) - 1))];
    const ReferenceTask task{cable.points, cable.length * rng.Uniform(1, 1.2) + rng.Uniform(1, 8), scene.to};
    const ReferenceSelection exact = SelectReference(scene.ground, task);
    const auto yen = SelectReferenceByYen(scene.ground, task, {.count = 40, .step_m = 0.8});
    ASSERT_TRUE(yen);
    if (!yen->reference) continue;
    ASSERT_TRUE(exact.reference);
    EXPECT_EQ(yen->reference->tether_word, cable.word * yen->reference->word);
    EXPECT_LE(exact.reference->length_m, yen->reference->length_m * (1 + 1e-9));
    EXPECT_LE(yen->reference->tether_length_m, task.cable_length_m * (1 + 1e-9));
    ++both;
  }
  EXPECT_GT(both, 0);
}

}  // namespace
}  // namespace tautline
