#include "tautline/planners/grid_manifold/lattice_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"

namespace tautline {
namespace {

constexpr long double kRoot = std::numbers::sqrt2_v<long double>;

TEST(LatticeDistance, ComparesAsTheLengthsDo) {
  Rng rng(1);
  const auto value = [](std::int64_t a, std::int64_t b) { return a * kStraightStep + b * kDiagonalStep; };
  for (std::int64_t i = 0; i < ScaledTestCount(100'000); ++i) {
    const int b = rng.UniformInt(0, 30'000);
    const int a = rng.UniformInt(0, static_cast<int>(46'000 - b * std::numbers::sqrt2));
    // The closest other length: another number of diagonal steps, and the straight ones that make up for it.
    const int b2 = rng.UniformInt(0, 30'000);
    const auto a2 = static_cast<std::int64_t>(std::llround(a + (b - b2) * kRoot));
    if (a2 < 0) continue;
    const long double difference = (a - a2) + (b - b2) * kRoot;
    const std::int64_t got = value(a, b) - value(a2, b2);
    ASSERT_EQ(got > 0, difference > 0) << a << " " << b << " " << a2 << " " << b2;
    ASSERT_EQ(got == 0, b == b2 && a == a2);
    ASSERT_NEAR(CellsOf(static_cast<LatticeDistance>(value(a, b))), a + b * std::numbers::sqrt2, 1e-10);
  }
}

TEST(LatticeDistance, ALimitHoldsLengthsThatAreItWritten) {
  for (int b = 0; b < 2000; b += 7) {
    const LatticeDistance value = 3 * kStraightStep + b * kDiagonalStep;
    EXPECT_LE(value, LimitOf(3 + b * std::numbers::sqrt2));
    EXPECT_GT(value, LimitOf((3 + b * std::numbers::sqrt2) * (1 - 3e-9)));
  }
  EXPECT_EQ(LimitOf(0), 0);
}

}  // namespace
}  // namespace tautline
