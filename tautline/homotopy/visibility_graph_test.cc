#include "tautline/homotopy/visibility_graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

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
      const TautEdge &edge = graph.edge(id), &back = graph.edge(edge.reverse);
      ASSERT_EQ(back.reverse, id);
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
      ASSERT_EQ(space.graph().OutOf(StanceOf(corner, Side::kLeft)).first.index(), edges);
      edges += out.size();
      std::vector<Sighting> held;
      for (const TautEdge& edge : out) {
        ASSERT_EQ(edge.from, corner);
        ASSERT_EQ(edge.length, Distance(space.corners()[corner].point, space.corners()[edge.to].point));
        held.push_back({edge.to, edge.tail, edge.head});
      }
      ASSERT_THAT(held, testing::UnorderedElementsAreArray(seen));
    }
    ASSERT_EQ(space.graph().edges().size(), edges);
  }
}

/// Every edge into a corner, and legs from elsewhere, go on with exactly the taut turns.
TEST_P(VisibilityGraphRandom, GoesOnWithTheTautTurns) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(300); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng, GetParam());
    const TautSpace space(scene.space);
    const VisibilityGraph& graph = space.graph();
    const auto expect_taut_turns = [&](Point from, CornerId corner, Side head, EdgeRange onward) {
      for (const Side tail : {Side::kLeft, Side::kRight}) {
        const EdgeRange out = graph.OutOf(StanceOf(corner, tail));
        for (EdgeId id = out.first; id < out.last; ++id) {
          const TautEdge& edge = graph.edge(id);
          const bool taut =
              tail == head && IsTautTurn(from, space.corners()[corner].point, head, space.corners()[edge.to].point);
          EXPECT_EQ(edge.tail, tail);
          EXPECT_EQ(onward.first <= id && id < onward.last, taut);
        }
      }
    };
    for (std::size_t e = 0; e < graph.edges().size(); ++e) {
      const TautEdge& edge = graph.edges()[e];
      expect_taut_turns(space.corners()[edge.from].point, edge.to, edge.head, graph.Onward(EdgeId(e)));
      ASSERT_EQ(graph.OnwardOfReverse(edge.reverse), graph.Onward(EdgeId(e)).first);
    }
    const Place place = space.Locate(RandomFreePoint(rng, scene)).value();
    for (const Sighting& leg : SeeFromPoint(space.mesh(), space.corners(), place)) {
      expect_taut_turns(place.point, leg.corner, leg.head,
                        graph.Onward(place.point, leg.corner, leg.head, space.corners()));
    }
    ASSERT_FALSE(HasFailure());
  }
}

}  // namespace
}  // namespace tautline
