#include "tautline/homotopy/visibility_graph.h"

#include <gtest/gtest.h>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/homotopy/random_scene.h"
#include "tautline/homotopy/taut_space.h"

namespace tautline {
namespace {

TEST(IsTautTurn, TurnsTowardsTheObstacleAndIsNeverStraight) {
  EXPECT_TRUE(IsTautTurn({0, 0}, {1, 0}, Side::kLeft, {2, 1}));
  EXPECT_FALSE(IsTautTurn({0, 0}, {1, 0}, Side::kLeft, {2, -1}));
  EXPECT_TRUE(IsTautTurn({0, 0}, {1, 0}, Side::kRight, {2, -1}));
  EXPECT_FALSE(IsTautTurn({0, 0}, {1, 0}, Side::kRight, {2, 1}));
  EXPECT_FALSE(IsTautTurn({0, 0}, {1, 0}, Side::kLeft, {2, 0}));
  EXPECT_FALSE(IsTautTurn({0, 0}, {1, 0}, Side::kRight, {2, 0}));
}

class VisibilityGraphRandom : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Families, VisibilityGraphRandom, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "Lattice" : "Separated"; });

TEST_P(VisibilityGraphRandom, IsTheSameBackwards) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(300); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const TautSpace space(MakeRandomScene(rng, GetParam()).space);
    const VisibilityGraph& graph = space.graph();
    for (std::size_t e = 0; e < graph.edges().size(); ++e) {
      const EdgeId id(e);
      const TautEdge &edge = graph.edge(id), &back = graph.edge(graph.Reverse(id));
      ASSERT_EQ(graph.Reverse(graph.Reverse(id)), id);
      ASSERT_EQ(back.from, edge.to);
      ASSERT_EQ(back.to, edge.from);
      ASSERT_EQ(back.length, edge.length);
      ASSERT_EQ(back.tail, Opposite(edge.head));
      ASSERT_EQ(back.head, Opposite(edge.tail));
    }
  }
}

TEST_P(VisibilityGraphRandom, HoldsWhatEachCornerSees) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(300); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const TautSpace space(MakeRandomScene(rng, GetParam()).space);
    std::size_t edges = 0;
    for (std::size_t c = 0; c < space.corners().size(); ++c) {
      const CornerId corner(c);
      const auto seen = SeeFromCorner(space.mesh(), space.corners(), corner);
      const auto out = space.graph().OutOf(corner);
      ASSERT_EQ(out.size(), seen.size());
      ASSERT_EQ(space.graph().First(corner).index(), edges);
      edges += out.size();
      for (std::size_t k = 0; k < out.size(); ++k) {
        ASSERT_EQ(out[k].from, corner);
        ASSERT_EQ((Sighting{out[k].to, out[k].tail, out[k].head}), seen[k]);
        ASSERT_EQ(out[k].length, Distance(space.corners()[corner].point, space.corners()[out[k].to].point));
      }
    }
    ASSERT_EQ(space.graph().edges().size(), edges);
  }
}

}  // namespace
}  // namespace tautline
