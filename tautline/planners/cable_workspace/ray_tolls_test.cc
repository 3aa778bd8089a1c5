#include "tautline/planners/cable_workspace/ray_tolls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <vector>

#include "tautline/base/test_scale.h"
#include "tautline/homotopy/classes.h"
#include "tautline/homotopy/random_scene.h"
#include "tautline/planners/cable_workspace/side_classes.h"
#include "tautline/planners/cable_workspace/side_crossing.h"

namespace tautline {
namespace {

/// Calls test(ground, anchors, rng) for random scenes with connected anchors.
template <class Test>
void ForRandomAnchors(std::int64_t count, Test test) {
  for (std::int64_t seed = 1, done = 0; done < ScaledTestCount(count); ++seed) {
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng);
    const auto ground = CableGround::Prepare(scene.world);
    if (!ground) continue;
    std::vector<Point> points;
    for (int i = rng.UniformInt(2, 4); i > 0; --i) points.push_back(RandomFreePoint(rng, scene));
    const auto anchors = PlaceAnchors(*ground, points);
    if (!anchors) continue;
    const bool connected = std::all_of(anchors->begin(), anchors->end(), [&](const Socket& anchor) {
      return ground->space().mesh().Connected((*anchors)[0].exit, anchor.exit);
    });
    if (!connected) continue;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    test(*ground, *anchors, rng);
    ++done;
  }
}

std::vector<TautPath> ClassesUpTo(const CableGround& ground, const Anchors& anchors, std::size_t side, double length) {
  return FindClasses(ground.space(), anchors[side].exit.point, anchors[NextAnchor(side, anchors.size())].exit.point,
                     {.max_length = length, .max_count = 2000})
      .classes;
}

double Sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

TEST(RayTollsTest, WithoutTollsTheCheapestSidesAreTheShortest) {
  ForRandomAnchors(100, [](const CableGround& ground, const Anchors& anchors, Rng&) {
    const RayTolls tolls = TollGraph(ground.space(), anchors).Free();
    for (std::size_t i = 0; i < anchors.size(); ++i) {
      const double shortest = ClassesUpTo(ground, anchors, i, 1e3)[0].length;
      EXPECT_NEAR(tolls.cheapest[i], shortest, 1e-9);
    }
  });
}

TEST(RayTollsTest, NoClassCostsLessThanTheCheapest) {
  std::int64_t raised = 0;
  ForRandomAnchors(200, [&](const CableGround& ground, const Anchors& anchors, Rng& rng) {
    const TollGraph graph(ground.space(), anchors);
    const double shortest = Sum(graph.Free().cheapest);
    const RayTolls tolls = graph.Raise(shortest * rng.Uniform(1, 3));
    EXPECT_GE(Sum(tolls.cheapest), shortest * (1 - 1e-9));
    raised += Sum(tolls.cheapest) > 1.01 * shortest ? 1 : 0;
    for (std::size_t i = 0; i < anchors.size(); ++i) {
      for (const TautPath& path : ClassesUpTo(ground, anchors, i, 2 * shortest)) {
        EXPECT_GE(path.length - RefundOf(ground.space(), tolls, path.points), tolls.cheapest[i] - 1e-9);
      }
    }
  });
  EXPECT_GE(raised, ScaledTestCount(20));
}

TEST(RayTollsTest, ListsTheClassesThatAreCheapEnough) {
  std::int64_t listed = 0;
  ForRandomAnchors(200, [&](const CableGround& ground, const Anchors& anchors, Rng& rng) {
    const TollGraph graph(ground.space(), anchors);
    const double shortest = Sum(graph.Free().cheapest), longest = shortest * rng.Uniform(0.5, 1.5);
    const RayTolls tolls = graph.Raise(shortest * rng.Uniform(1, 3));
    const double cost = tolls.cheapest[0] + shortest * rng.Uniform(0, 0.5);
    const auto classes = ClassesUpTo(ground, anchors, 0, longest);
    if (classes.size() == 2000) return;
    const bool on_walls =
        EndsOnBoundary(ground.space(), anchors[0].exit) && EndsOnBoundary(ground.space(), anchors[1].exit);
    const bool drop_loops = LoopsCross(ground.space(), anchors[0].exit, anchors[1].exit);
    SearchBudget budget(1'000'000, {});
    std::set<Polyline> found, expected;
    for (const TautPath& path : ListSideClasses(ground.space(), anchors, 0, graph, tolls,
                                                {.max_cost = cost,
                                                .max_length = longest,
                                                .drop_crossing = on_walls,
                                                .drop_loops = drop_loops,
                                                .budget = &budget})) {
      EXPECT_TRUE(found.insert(path.points).second);
    }
    for (const TautPath& path : classes) {
      if (path.length - RefundOf(ground.space(), tolls, path.points) > cost) continue;
      const Walk walk = WalkBetween(ground, anchors[0], anchors[1 % anchors.size()], path);
      // Those that cross themselves may be left out.
      if (on_walls && found.count(path.points) == 0 && CablesCross(ground.space(), walk, walk)) {
        continue;
      }
      expected.insert(path.points);
    }
    EXPECT_EQ(found, expected);
    listed += static_cast<std::int64_t>(found.size());
  });
  EXPECT_GE(listed, ScaledTestCount(200));
}

}  // namespace
}  // namespace tautline
