#include "tautline/homotopy/goal_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/homotopy/random_scene.h"

namespace tautline {
namespace {

class GoalFieldRandom : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Families, GoalFieldRandom, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "Lattice" : "Separated"; });

/// The least of the last leg and all taut ways on, by the definition.
double BestWayOn(const TautSpace& space, const GoalField& field, const TautEdge& edge) {
  const Point from = space.corners()[edge.from].point, here = space.corners()[edge.to].point;
  double least = field.LastLeg(edge.to, edge.head, from).value_or(std::numeric_limits<double>::infinity());
  for (const TautEdge& out : space.graph().OutOf(edge.to)) {
    const bool taut = out.tail == edge.head && IsTautTurn(from, here, edge.head, space.corners()[out.to].point);
    if (taut) least = std::min(least, out.length + field.Beyond(space.graph().edge(out.reverse).reverse));
  }
  return least;
}

TEST_P(GoalFieldRandom, SolvesTheEquationOfShortestWays) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(200); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng, GetParam());
    const TautSpace space(scene.space);
    const Place goal = space.Locate(RandomFreePoint(rng, scene)).value();
    GoalField field(space, goal);
    field.GrowTo(std::numeric_limits<double>::infinity());
    const double limit = rng.Uniform(0, 20);
    GoalField limited(space, goal);
    limited.GrowTo(limit / 2);
    limited.GrowTo(limit);
    for (std::size_t e = 0; e < space.graph().edges().size(); ++e) {
      const double beyond = field.Beyond(EdgeId(e)), way_on = BestWayOn(space, field, space.graph().edges()[e]);
      // Edge lengths are positive, so the equation has one solution only.
      if (std::isinf(way_on)) {
        ASSERT_TRUE(std::isinf(beyond));
      } else {
        ASSERT_NEAR(beyond, way_on, 1e-12 * (1 + way_on));
      }
      ASSERT_EQ(limited.Beyond(EdgeId(e)), beyond <= limit ? beyond : std::numeric_limits<double>::infinity());
    }
  }
}

TEST_P(GoalFieldRandom, HasTheLegsThatItsGoalSees) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(200); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng, GetParam());
    const TautSpace space(scene.space);
    const Place goal = space.Locate(RandomFreePoint(rng, scene)).value();
    const GoalField field(space, goal);
    const auto legs = LegsFrom(space, goal);
    for (std::size_t c = 0; c < space.corners().size(); ++c) {
      const Corner& corner = space.corners().all()[c];
      const auto leg =
          std::find_if(legs.begin(), legs.end(), [c](const TautLeg& l) { return l.corner == CornerId(c); });
      const Point from = random_scene::RandomPlace(rng, scene);
      for (const Side head : {Side::kLeft, Side::kRight}) {
        const bool expected =
            leg != legs.end() && Opposite(leg->side) == head && IsTautTurn(from, corner.point, head, goal.point);
        const auto found = field.LastLeg(CornerId(c), head, from);
        ASSERT_EQ(found.has_value(), expected);
        if (expected) {
          ASSERT_EQ(*found, Distance(corner.point, goal.point));
        }
      }
    }
  }
}

}  // namespace
}  // namespace tautline
