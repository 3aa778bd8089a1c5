#include "tautline/geometry/self_crossing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/polygon.h"
#include "tautline/geometry/predicates.h"
#include "tautline/geometry/random_rings.h"

namespace tautline {
namespace {

bool CrossesItself(const Ring& ring) { return FindSelfCrossing(ring).has_value(); }

TEST(FindSelfCrossing, NamesTheEdgesOfABowTie) {
  const Ring bow_tie{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
  EXPECT_EQ(FindSelfCrossing(bow_tie), (EdgePair{0, 2}));
}

TEST(FindSelfCrossing, ASquareHasNone) { EXPECT_FALSE(CrossesItself({{0, 0}, {2, 0}, {2, 2}, {0, 2}})); }

TEST(FindSelfCrossing, TouchingAtAVertexIsAllowed) {
  // Two triangles that share the corner (1, 1), walked one after the other.
  EXPECT_FALSE(CrossesItself({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}}));
  // The vertex (1, 0) touches the bottom edge from above.
  EXPECT_FALSE(CrossesItself({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}));
}

TEST(FindSelfCrossing, CrossingAtAVertexIsFound) {
  // A bow tie whose crossing point is a vertex of both ways.
  EXPECT_TRUE(CrossesItself({{0, 0}, {1, 1}, {2, 2}, {2, 0}, {1, 1}, {0, 2}}));
  // The vertex (1, 0) lies on the bottom edge and the ring goes on below it.
  EXPECT_TRUE(CrossesItself({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, -2}}));
}

TEST(FindSelfCrossing, CrossingAlongACommonEdgeIsFound) {
  // Two triangles on both sides of the edge (0, 5)-(5, 1), walked twice in the same direction.
  EXPECT_TRUE(CrossesItself({{0, 5}, {5, 1}, {14, 12}, {0, 5}, {5, 1}, {0, 0}}));
  // A bow tie whose crossing is the edge (2, 1)-(3, 1).
  EXPECT_TRUE(CrossesItself({{0, 0}, {2, 1}, {3, 1}, {5, 2}, {5, 0}, {3, 1}, {2, 1}, {0, 2}}));
  // Two triangles at the ends of a corridor without width.
  EXPECT_FALSE(CrossesItself({{0, 0}, {2, 1}, {3, 1}, {5, 0}, {5, 2}, {3, 1}, {2, 1}, {0, 2}}));
}

TEST(FindSelfCrossing, RunningBackAlongAnEdgeIsAllowed) {
  EXPECT_FALSE(CrossesItself({{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 2}, {2, 4}, {0, 4}}));
}

/// The oracle looks at proper crossings of all pairs; random points touch nowhere.
bool SomePairCrosses(const Ring& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      if (CrossProperly(ring[i], ring[(i + 1) % n], ring[j], ring[(j + 1) % n])) return true;
    }
  }
  return false;
}

TEST(FindSelfCrossing, AgreesWithAllPairsOnRandomRings) {
  Rng rng(3);
  int crossing = 0;
  const std::int64_t count = ScaledTestCount(3000);
  for (std::int64_t i = 0; i < count; ++i) {
    Ring ring;
    const int size = rng.UniformInt(3, 9);
    for (int k = 0; k < size; ++k) ring.push_back({rng.Uniform(), rng.Uniform()});
    EXPECT_EQ(CrossesItself(ring), SomePairCrosses(ring));
    crossing += SomePairCrosses(ring) ? 1 : 0;
  }
  EXPECT_GT(crossing, 0);
}

TEST(FindSelfCrossing, StarsHaveNone) {
  Rng rng(4);
  for (int i = 0; i < ScaledTestCount(500); ++i) EXPECT_FALSE(CrossesItself(RandomStar(rng, {0, 0}, 1)));
}

TEST(FindSelfCrossing, LongRingsAreFast) {
  Ring ring;
  constexpr int kPoints = 200000;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2 * std::numbers::pi * i / kPoints, radius = 100 + (i % 2);
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  EXPECT_FALSE(CrossesItself(ring));
}

/// A bar with `teeth` thin teeth, a thousand times as long as they are apart, all turned.
Ring Comb(int teeth, double turn_rad) {
  Ring ring;
  for (int i = 0; i < teeth; ++i) {
    ring.push_back({1.0 * i, 1});
    ring.push_back({i + 0.5, 1000});
  }
  ring.push_back({1.0 * teeth, 0});
  ring.push_back({0, 0});
  for (Point& p : ring) {
    p = {p.x * std::cos(turn_rad) - p.y * std::sin(turn_rad), p.x * std::sin(turn_rad) + p.y * std::cos(turn_rad)};
  }
  return ring;
}

TEST(FindSelfCrossing, CombsAreFast) {
  // The box of a slanted tooth meets those of a thousand others; pair by pair this takes minutes.
  for (const double turn_rad : {0.0, 0.7, 3.0}) {
    Ring comb = Comb(100000, turn_rad);
    EXPECT_FALSE(CrossesItself(comb)) << turn_rad;
    // The tip of one tooth among its neighbours.
    comb[100001] = comb[100001] + 1.5 * (comb[100002] - comb[100000]);
    EXPECT_TRUE(CrossesItself(comb)) << turn_rad;
  }
}

}  // namespace
}  // namespace tautline
