#include "tautline/planners/tether/circle_span.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

constexpr double kPi = std::numbers::pi;

Point RandomPoint(Rng& rng) { return {rng.Uniform(-3, 3), rng.Uniform(-3, 3)}; }

bool Holds(const std::vector<AngleSpan>& spans, double angle) {
  for (const AngleSpan& span : spans) {
    for (const double turn : {-2 * kPi, 0.0, 2 * kPi}) {
      if (span.low <= angle + turn && angle + turn <= span.high) return true;
    }
  }
  return false;
}

std::vector<AngleSpan> SpansOf(const AngleRange& range) {
  const AngleSpan circle{-kPi, kPi};
  return Intersect({&circle, 1}, range);
}

TEST(CircleSpan, LeftOfALineIsWhatTheOrientationSays) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(2000); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const Disc disc{RandomPoint(rng), rng.Uniform(0.1, 3)};
    const Point a = RandomPoint(rng), b = RandomPoint(rng);
    const auto left = SpansOf(LeftOfLine(disc, a, b));
    for (int i = 0; i < 20; ++i) {
      const double angle = rng.Uniform(-kPi, kPi);
      ASSERT_EQ(Holds(left, angle), Orientation(a, b, PointAt(disc, angle)) > 0);
    }
  }
}

TEST(CircleSpan, BothSidesOfALineMeetInTheSamePoints) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(2000); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const Disc disc{RandomPoint(rng), rng.Uniform(0.1, 3)};
    const Point a = RandomPoint(rng), b = RandomPoint(rng);
    const AngleRange left = LeftOfLine(disc, a, b), right = LeftOfLine(disc, b, a);
    const Chord chord = ChordOf(disc, a, b);
    ASSERT_EQ(chord.entry(), ChordOf(disc, b, a).entry());
    if (!chord.crosses) continue;
    ASSERT_NEAR(left.half + right.half, kPi, 1e-12);
    const Point low = PointAt(disc, left.middle - left.half), high = PointAt(disc, right.middle + right.half);
    ASSERT_NEAR(Distance(low, high), 0, 1e-12);
    ASSERT_NEAR(std::min(Distance(low, chord.entry()), Distance(low, chord.exit())), 0, 1e-12);
  }
}

TEST(CircleSpan, InsideADiscIsWhatTheDistanceSays) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(2000); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const Disc disc{RandomPoint(rng), rng.Uniform(0.1, 3)}, other{RandomPoint(rng), rng.Uniform(0.1, 3)};
    const auto inside = SpansOf(InsideDisc(disc, other, false));
    for (int i = 0; i < 20; ++i) {
      const double angle = rng.Uniform(-kPi, kPi);
      ASSERT_EQ(Holds(inside, angle), Distance(PointAt(disc, angle), other.centre) <= other.radius);
    }
  }
}

TEST(CircleSpan, OfEqualCirclesOneWins) {
  const Disc disc{{1, 2}, 3};
  EXPECT_LT(InsideDisc(disc, disc, false).half, 0);
  EXPECT_GE(InsideDisc(disc, disc, true).half, kPi);
  EXPECT_GE(InsideDisc(disc, {{1, 2}, 4}, false).half, kPi);
  EXPECT_LT(InsideDisc(disc, {{1, 2}, 2}, true).half, 0);
}

TEST(CircleSpan, UncoveredDropsWhatRoundingLeaves) {
  const auto rest = Uncovered({0, 3}, {{2, 2.5}, {0.5, 1}, {1 + 1e-15, 1.5}, {2.5, 3 - 1e-15}}, 1e-12);
  ASSERT_EQ(rest.size(), 2u);
  EXPECT_EQ(rest[0].low, 0);
  EXPECT_EQ(rest[0].high, 0.5);
  EXPECT_EQ(rest[1].low, 1.5);
  EXPECT_EQ(rest[1].high, 2);
}

}  // namespace
}  // namespace tautline
