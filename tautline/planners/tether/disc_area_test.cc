#include "tautline/planners/tether/disc_area.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tautline/base/test_scale.h"
#include "tautline/geometry/random_rings.h"

namespace tautline {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(AreaInDisc, KnownShapes) {
  const Ring square = Rectangle({-2, -2}, {2, 2});
  EXPECT_NEAR(AreaInDisc(square, {{0, 0}, 1}), kPi, 1e-15);
  EXPECT_NEAR(AreaInDisc(square, {{0, 0}, 3}), 16, 1e-14);
  EXPECT_NEAR(AreaInDisc(square, {{-2, -2}, 1}), kPi / 4, 1e-15);
  EXPECT_NEAR(AreaInDisc(square, {{0, 2}, 1}), kPi / 2, 1e-15);
  EXPECT_NEAR(AreaInDisc(square, {{5, 0}, 3}), 0, 1e-14);
  const double cap = 9 * std::acos(2.0 / 3) - 2 * std::sqrt(5);
  EXPECT_NEAR(AreaInDisc(Rectangle({-9, -9}, {2, 9}), {{0, 0}, 3}), 9 * kPi - cap, 1e-13);
}

TEST(AreaInDisc, AgreesWithFineStrips) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(50); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const Ring ring = RandomStar(rng, {0, 0}, 2);
    const Disc disc{{rng.Uniform(-2, 2), rng.Uniform(-2, 2)}, rng.Uniform(0.1, 3)};
    constexpr int kSteps = 400;
    const double cell = 2 * disc.radius / kSteps;
    double area = 0;
    for (int i = 0; i < kSteps; ++i) {
      for (int j = 0; j < kSteps; ++j) {
        const Point p = disc.centre - Point{disc.radius, disc.radius} + cell * Point{i + 0.5, j + 0.5};
        if (Distance(p, disc.centre) < disc.radius && ContainsPoint(ring, p)) area += cell * cell;
      }
    }
    // Cells on the boundary are half wrong at the most, and half of those cancel.
    ASSERT_NEAR(AreaInDisc(ring, disc), SignedArea(ring) > 0 ? area : -area, 60 * cell * cell);
  }
}

TEST(AreaInDisc, TurnsItsSignWithTheRing) {
  Rng rng(1);
  const Ring ring = RandomStar(rng, {0, 0}, 2);
  EXPECT_NEAR(AreaInDisc(Ring(ring.rbegin(), ring.rend()), {{1, 0}, 1.5}), -AreaInDisc(ring, {{1, 0}, 1.5}), 1e-14);
}

}  // namespace
}  // namespace tautline
