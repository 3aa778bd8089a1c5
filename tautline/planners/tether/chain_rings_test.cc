#include "tautline/planners/tether/chain_rings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "tautline/base/rng.h"
#include "tautline/geometry/polygon.h"

namespace tautline {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kTolerance = 1e-9;

RegionPiece Wall(Point from, Point to, std::int64_t source = 0) { return {.from = from, .to = to, .source = source}; }

RegionPiece Arc(Point centre, double radius, double low, double high) {
  const auto at = [&](double angle) { return centre + radius * Point{std::cos(angle), std::sin(angle)}; };
  return {.kind = PieceKind::kArc,
          .from = at(low),
          .to = at(high),
          .centre = centre,
          .radius = radius,
          .sweep = high - low};
}

TEST(ChainRings, AFullCircleInParts) {
  const auto rings = ChainRings({Arc({1, 1}, 2, 1, 3), Arc({1, 1}, 2, 3, 1 + 2 * kPi)}, kTolerance);
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_EQ(rings[0].pieces.size(), 1u);
  EXPECT_NEAR(rings[0].area, 4 * kPi, 1e-13);
}

TEST(ChainRings, AHalfDiscWithAHole) {
  const auto rings = ChainRings({Wall({1, 0}, {2, 0}, 7), Arc({0, 0}, 2, 0, kPi), Wall({-2, 0}, {1, 0}, 7),
                                 Wall({0, 0.5}, {0, 1}, 1), Wall({0, 1}, {0.5, 1}, 2), Wall({0.5, 1}, {0, 0.5}, 3)},
                                kTolerance);
  ASSERT_EQ(rings.size(), 2u);
  double hole = 0, all = 0;
  for (const RegionRing& ring : rings) {
    hole = std::min(hole, ring.area);
    all += ring.area;
  }
  EXPECT_NEAR(hole, -0.125, 1e-15);
  EXPECT_NEAR(all, 2 * kPi - 0.125, 1e-13);
}

TEST(ChainRings, RingsThatTouchStayTwo) {
  std::vector<RegionPiece> pieces;
  const Ring left = {{0, 0}, {1, 0.5}, {0, 1}}, right = {{1, 0.5}, {2, 0}, {2, 1}};
  std::int64_t source = 0;
  for (const Ring& ring : {left, right}) {
    for (std::size_t i = 0; i < 3; ++i) pieces.push_back(Wall(ring[i], ring[(i + 1) % 3], ++source));
  }
  const auto rings = ChainRings(pieces, kTolerance);
  ASSERT_EQ(rings.size(), 2u);
  EXPECT_NEAR(rings[0].area, 0.5, 1e-15);
  EXPECT_NEAR(rings[1].area, 0.5, 1e-15);
}

TEST(ChainRings, AnyOrderAndNoisyEnds) {
  std::vector<RegionPiece> pieces;
  constexpr int kSides = 30;
  Rng rng(5);
  const auto at = [&](int i) {
    const double angle = 2 * kPi * i / kSides;
    return Point{std::cos(angle) + rng.Uniform(-2e-10, 2e-10), std::sin(angle) + rng.Uniform(-2e-10, 2e-10)};
  };
  for (int i = 0; i < kSides; ++i) pieces.push_back(Wall(at(i), at(i + 1), i));
  pieces.push_back(Wall({1, 0}, {1 + 1e-10, 0}, 99));
  for (std::size_t i = pieces.size(); i > 1; --i) {
    std::swap(pieces[i - 1], pieces[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(i) - 1))]);
  }
  const auto rings = ChainRings(pieces, kTolerance);
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_EQ(rings[0].pieces.size(), static_cast<std::size_t>(kSides));
  EXPECT_NEAR(rings[0].area, 0.5 * kSides * std::sin(2 * kPi / kSides), 1e-8);
}

TEST(ChainRings, AnOpenBoundaryIsAFault) {
  EXPECT_THROW(ChainRings({Wall({0, 0}, {1, 0}, 1), Wall({1, 0}, {1, 1}, 2)}, kTolerance), std::logic_error);
}

}  // namespace
}  // namespace tautline
