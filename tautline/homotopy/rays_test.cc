#include "tautline/homotopy/rays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// A free space of which only the islands matter: a, b, c, ... with these representatives.
FreeSpace Islands(const std::vector<Point>& representatives) {
  FreeSpace space;
  for (const Point p : representatives) {
    space.islands.push_back({std::string(1, static_cast<char>('a' + space.islands.size())), p, {}, 0});
  }
  return space;
}

std::string Text(const Rays& rays, const Polyline& polyline) { return ToString(rays.WordOf(polyline), rays.names()); }

Polyline Reversed(Polyline polyline) {
  std::reverse(polyline.begin(), polyline.end());
  return polyline;
}

// Two pillars side by side:
//
//    |   |        rays
//    a   b        at (2, 2) and (6, 2)
class RaysOfTwoPillars : public testing::Test {
 protected:
  Rays rays_{Islands({{2, 2}, {6, 2}})};
};

TEST_F(RaysOfTwoPillars, LeftToRightWritesTheLetter) {
  EXPECT_EQ(Text(rays_, {{0, 4}, {4, 4}}), "a");
  EXPECT_EQ(Text(rays_, {{4, 4}, {0, 4}}), "a^-1");
  EXPECT_EQ(Text(rays_, {{0, 4}, {8, 4}}), "a b");
  EXPECT_EQ(Text(rays_, {{8, 4}, {0, 4}}), "b^-1 a^-1");
}

TEST_F(RaysOfTwoPillars, BelowIsNothing) {
  EXPECT_EQ(Text(rays_, {{0, 1}, {8, 1}}), "");
  EXPECT_EQ(Text(rays_, {{0, 1}, {8, 4}}), "b");
  EXPECT_EQ(Text(rays_, {}), "");
  EXPECT_EQ(Text(rays_, {{0, 4}}), "");
}

TEST_F(RaysOfTwoPillars, WindingAroundOne) {
  const Polyline around_a{{1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}};
  EXPECT_EQ(Text(rays_, around_a), "a");
  EXPECT_EQ(Text(rays_, Reversed(around_a)), "a^-1");
}

TEST_F(RaysOfTwoPillars, APointAboveARepresentativeIsToItsRight) {
  EXPECT_EQ(Text(rays_, {{0, 4}, {2, 4}}), "a");
  EXPECT_EQ(Text(rays_, {{2, 4}, {4, 4}}), "");
  EXPECT_EQ(Text(rays_, {{4, 4}, {2, 4}}), "");
  EXPECT_EQ(Text(rays_, {{2, 4}, {0, 4}}), "a^-1");
  EXPECT_EQ(Text(rays_, {{2, 4}, {2, 9}}), "");
  EXPECT_EQ(Text(rays_, {{0, 4}, {2, 4}, {2, 9}, {0, 5}}), "");
  EXPECT_EQ(Text(rays_, {{0, 4}, {2, 4}, {2, 9}, {4, 5}}), "a");
}

TEST_F(RaysOfTwoPillars, HomologyForgetsTheOrder) {
  const Polyline commutator{{1, 1}, {1, 3}, {3, 3}, {3, 1}, {5, 1}, {5, 3}, {7, 3}, {7, 1}, {3, 1},
                            {3, 3}, {1, 3}, {1, 1}, {7, 1}, {7, 3}, {5, 3}, {5, 1}, {1, 1}};
  EXPECT_EQ(Text(rays_, commutator), "a b a^-1 b^-1");
  EXPECT_EQ(rays_.HomologyOf(commutator), (std::vector<int>{0, 0}));
  EXPECT_EQ(rays_.HomologyOf(Polyline{{0, 4}, {8, 4}, {8, 0}, {0, 0}, {0, 4}, {4, 4}}), (std::vector<int>{2, 1}));
}

TEST(Rays, OfOneColumnAreOrderedAlongTheTravel) {
  // Listed with the upper one first: the order is that of the ids, not of the heights.
  const Rays rays(Islands({{2, 6}, {2, 2}}));
  EXPECT_EQ(Text(rays, {{0, 8}, {4, 8}}), "a b");
  EXPECT_EQ(Text(rays, {{4, 8}, {0, 8}}), "b^-1 a^-1");
  EXPECT_EQ(Text(rays, {{0, 4}, {4, 4}}), "b");
  EXPECT_EQ(Text(rays, {{4, 4}, {0, 4}}), "b^-1");
  EXPECT_EQ(Text(rays, {{0, 8}, {2, 8}}), "a b");
  EXPECT_EQ(Text(rays, {{2, 4}, {0, 4}}), "b^-1");
  // Around the upper one, between the two.
  EXPECT_EQ(Text(rays, {{0, 4}, {0, 8}, {4, 8}, {4, 4}, {0, 4}}), "a");
}

TEST(Rays, OrderOfIdsIsNotTheOrderInThePlane) {
  const Rays rays(Islands({{6, 2}, {2, 2}, {4, 2}}));
  EXPECT_EQ(Text(rays, {{0, 4}, {8, 4}}), "b c a");
  EXPECT_EQ(rays.HomologyOf(Polyline{{0, 4}, {5, 4}}), (std::vector<int>{0, 1, 1}));
}

TEST(Rays, OfNoIslands) {
  const Rays rays(Islands({}));
  EXPECT_EQ(Text(rays, {{0, 0}, {5, 5}}), "");
  EXPECT_TRUE(rays.HomologyOf(Polyline{{0, 0}, {5, 5}}).empty());
}

Point LatticePoint(Rng& rng) { return {1.0 * rng.UniformInt(0, 8), 1.0 * rng.UniformInt(0, 8)}; }

bool InTriangle(Point a, Point b, Point c, Point p) {
  const int ab = Orientation(a, b, p), bc = Orientation(b, c, p), ca = Orientation(c, a, p);
  if (Orientation(a, b, c) == 0) return OnSegment(a, b, p) || OnSegment(b, c, p) || OnSegment(c, a, p);
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

/// Representatives on a lattice, so that they share columns and lie under vertices of the polyline.
struct RandomCase {
  std::vector<Point> representatives;
  Polyline polyline;

  explicit RandomCase(Rng& rng) {
    for (int i = rng.UniformInt(1, 6); i > 0; --i) representatives.push_back(LatticePoint(rng));
    while (polyline.size() < 6) {
      const Point next = LatticePoint(rng);
      if (polyline.empty() ? Free(next, next, next) : Free(polyline.back(), next, next)) polyline.push_back(next);
    }
  }

  /// Whether the closed triangle holds no representative.
  bool Free(Point a, Point b, Point c) const {
    return std::none_of(representatives.begin(), representatives.end(),
                        [&](Point p) { return InTriangle(a, b, c, p); });
  }
};

TEST(Rays, HomotopicPathsHaveEqualWords) {
  const std::int64_t count = ScaledTestCount(20000);
  std::int64_t moved = 0;
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomCase c(rng);
    const Rays rays(Islands(c.representatives));
    const Word word = rays.WordOf(c.polyline);
    const auto i = static_cast<std::size_t>(rng.UniformInt(1, 4));
    const Point before = c.polyline[i - 1], from = c.polyline[i], after = c.polyline[i + 1], to = LatticePoint(rng);
    if (!c.Free(before, from, to) || !c.Free(from, to, after)) continue;
    ++moved;
    Polyline bent = c.polyline;
    bent[i] = to;
    ASSERT_EQ(rays.WordOf(bent), word);
    ASSERT_EQ(rays.HomologyOf(bent), rays.HomologyOf(c.polyline));
  }
  EXPECT_GT(moved, count / 20);
}

TEST(Rays, WordsOfPartsAndReversals) {
  const std::int64_t count = ScaledTestCount(5000);
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomCase c(rng);
    const Rays rays(Islands(c.representatives));
    const Word word = rays.WordOf(c.polyline);
    ASSERT_EQ(rays.WordOf(Reversed(c.polyline)), word.Inverse());
    const std::span<const Point> all(c.polyline);
    ASSERT_EQ(rays.WordOf(all.first(4)) * rays.WordOf(all.subspan(3)), word);
    ASSERT_EQ(Abelianize(word, c.representatives.size()), rays.HomologyOf(c.polyline));
    Polyline halved;
    for (std::size_t k = 0; k + 1 < all.size(); ++k) {
      halved.push_back(all[k]);
      halved.push_back(Lerp(all[k], all[k + 1], 0.5));
    }
    halved.push_back(all.back());
    ASSERT_EQ(rays.WordOf(halved), word);
  }
}

TEST(Rays, AMirroredPathHasTheMirroredWord) {
  // Mirroring swaps left and right: every letter turns into its inverse. Off the lattice, where no column is shared.
  const std::int64_t count = ScaledTestCount(2000);
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    std::vector<Point> representatives, mirrored;
    for (int i = 0; i < 5; ++i) representatives.push_back({rng.Uniform(0, 8), rng.Uniform(0, 8)});
    for (const Point p : representatives) mirrored.push_back({-p.x, p.y});
    Polyline polyline, mirrored_polyline;
    for (int i = 0; i < 8; ++i) polyline.push_back({rng.Uniform(0, 8), rng.Uniform(0, 8)});
    for (const Point p : polyline) mirrored_polyline.push_back({-p.x, p.y});
    Word expected;
    const Word word = Rays(Islands(representatives)).WordOf(polyline);
    for (const Letter letter : word.letters()) expected.Append({letter.obstacle, !letter.inverse});
    ASSERT_EQ(Rays(Islands(mirrored)).WordOf(mirrored_polyline), expected);
  }
}

}  // namespace
}  // namespace tautline
