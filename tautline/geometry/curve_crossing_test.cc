#include "tautline/geometry/curve_crossing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/polygon.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

bool Crosses(const Polyline& curve) { return FindCurveCrossing(curve).has_value(); }

TEST(FindCurveCrossing, NamesThePlaceOfAProperCrossing) {
  EXPECT_EQ(FindCurveCrossing(Polyline{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, -2}}), (Point{2, 0}));
}

TEST(FindCurveCrossing, TouchingIsNoCrossing) {
  // It ends on itself, starts on itself, and touches itself with a bend.
  EXPECT_FALSE(Crosses({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 0}}));
  EXPECT_FALSE(Crosses({{2, 0}, {2, 2}, {4, 2}, {4, 0}, {0, 0}}));
  EXPECT_FALSE(Crosses({{0, 0}, {4, 0}, {4, 2}, {3, 2}, {2, 0}, {1, 2}}));
}

TEST(FindCurveCrossing, PassingThroughABendIsACrossing) {
  EXPECT_TRUE(Crosses({{0, 0}, {2, 1}, {4, 0}, {4, 3}, {2, 3}, {2, -1}}));
  EXPECT_TRUE(Crosses({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 0}, {1, -2}}));
}

TEST(FindCurveCrossing, ComesOffARunOnOneSideOrTheOther) {
  // Back along the segment from (2, 0) to (1, 0).
  EXPECT_FALSE(Crosses({{0, 0}, {4, 0}, {4, 2}, {2, 0}, {1, 0}, {0, 2}}));
  EXPECT_TRUE(Crosses({{0, 0}, {4, 0}, {4, 2}, {2, 0}, {1, 0}, {0, -2}}));
  // Once more along it in the same direction.
  EXPECT_FALSE(Crosses({{0, 0}, {4, 0}, {4, 2}, {0, 2}, {1, 0}, {2, 0}, {3, 1}}));
  EXPECT_TRUE(Crosses({{0, 0}, {4, 0}, {4, 2}, {0, 2}, {1, 0}, {2, 0}, {3, -1}}));
  // A run that an end lies on is none.
  EXPECT_FALSE(Crosses({{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 0}}));
  EXPECT_FALSE(Crosses({{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 0}, {-2, -2}}));
}

TEST(FindCurveCrossing, TwoTurnsAroundOneSquareCrossUnlessTheyEndOnIt) {
  const Polyline once{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  Polyline twice{{-2, -1}};
  for (int turn = 0; turn < 2; ++turn) twice.insert(twice.end(), once.begin(), once.end());
  EXPECT_FALSE(Crosses(twice));
  twice.push_back({-1, -3});
  EXPECT_TRUE(Crosses(twice));
}

/// Pushes every point of the curve off, a little, at random.
Polyline Shaken(Rng& rng, Polyline curve) {
  constexpr double kShake = 1e-4;
  for (Point& p : curve) p = p + Point{rng.Uniform(-kShake, kShake), rng.Uniform(-kShake, kShake)};
  return curve;
}

/// Without a turn on the spot and with no repeated points.
Polyline RandomLatticeCurve(Rng& rng, int n) {
  Polyline curve;
  while (static_cast<int>(curve.size()) < n) {
    const Point p{static_cast<double>(rng.UniformInt(0, 4)), static_cast<double>(rng.UniformInt(0, 4))};
    const std::size_t k = curve.size();
    if (k > 0 && curve[k - 1] == p) continue;
    if (k > 1 && Orientation(curve[k - 2], curve[k - 1], p) == 0 &&
        Dot(curve[k - 1] - curve[k - 2], p - curve[k - 1]) < 0) {
      continue;
    }
    curve.push_back(p);
  }
  return curve;
}

/// A curve that crosses itself does so however it is shaken; one that does not, and has no runs, can be shaken free.
TEST(FindCurveCrossing, HoldsAgainstShakenCurves) {
  int crossing = 0, free = 0;
  const std::int64_t count = ScaledTestCount(3000);
  for (std::int64_t seed = 0; seed < count; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const Polyline curve = RandomLatticeCurve(rng, 5);
    const bool crosses = Crosses(curve);
    int shaken_free = 0;
    for (int k = 0; k < 200; ++k) shaken_free += Crosses(Shaken(rng, curve)) ? 0 : 1;
    EXPECT_EQ(crosses, shaken_free == 0);
    EXPECT_EQ(Crosses(Polyline(curve.rbegin(), curve.rend())), crosses);
    (crosses ? crossing : free) += 1;
  }
  EXPECT_GT(crossing, count / 10);
  EXPECT_GT(free, count / 10);
}

TEST(EntersRing, TellsTheInsideFromTheBoundary) {
  Ring ring{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}};
  for (int turn = 0; turn < 2; ++turn) {
    EXPECT_TRUE(EntersRing(ring, {1, 1}, {1, 1.5}));
    EXPECT_TRUE(EntersRing(ring, {-1, 1}, {5, 1}));
    EXPECT_TRUE(EntersRing(ring, {0, 0}, {1, 1}));
    EXPECT_TRUE(EntersRing(ring, {2, 0}, {2, 9}));
    EXPECT_TRUE(EntersRing(ring, {2, 9}, {2, 0.5}));
    EXPECT_FALSE(EntersRing(ring, {0, 0}, {4, 0}));
    EXPECT_FALSE(EntersRing(ring, {2, 9}, {2, 1}));
    EXPECT_FALSE(EntersRing(ring, {-1, 0}, {9, 0}));
    EXPECT_FALSE(EntersRing(ring, {0, 4}, {4, 4}));
    EXPECT_FALSE(EntersRing(ring, {2, 0}, {1, -1}));
    EXPECT_FALSE(EntersRing(ring, {-1, 3}, {1, 5}));
    std::reverse(ring.begin(), ring.end());
  }
}

/// Against many points of the segment.
TEST(EntersRing, HoldsAgainstSamples) {
  const Ring ring{{0, 0}, {3, 1}, {5, 0}, {4, 3}, {5, 5}, {2, 4}, {0, 5}, {1, 2}};
  int entered = 0;
  const std::int64_t count = ScaledTestCount(2000);
  for (std::int64_t seed = 0; seed < count; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const auto point = [&rng] {
      return Point{static_cast<double>(rng.UniformInt(-1, 6)), static_cast<double>(rng.UniformInt(-1, 6))};
    };
    const Point a = point(), b = point();
    if (a == b) continue;
    // Quarters and sixteenths are exact, and the lattice lets no segment in for less than a few of them.
    bool inside = false;
    for (int k = 0; k <= 4096; ++k) {
      const Winding winding = WindingNumber(ring, Lerp(a, b, k / 4096.0));
      // Beside slanted edges the samples are rounded: look from a point a little off.
      inside = inside || (!winding.on_boundary && winding.number != 0);
    }
    if (EntersRing(ring, a, b)) {
      ++entered;
      EXPECT_TRUE(inside);
    } else {
      const Point middle = Lerp(a, b, 0.5);
      const Winding winding = WindingNumber(ring, middle);
      EXPECT_TRUE(winding.on_boundary || winding.number == 0);
    }
  }
  EXPECT_GT(entered, count / 4);
}

TEST(FindFirstMeeting, IsTheNearestAlongTheCurve) {
  const Polyline other{{2, -1}, {2, 1}, {1, 1}, {1, -1}};
  const auto meeting = FindFirstMeeting(Polyline{{0, 5}, {0, 0}, {4, 0}}, other);
  ASSERT_TRUE(meeting);
  EXPECT_EQ(meeting->on_curve, 1U);
  EXPECT_EQ(meeting->on_other, 2U);
  EXPECT_EQ(meeting->at, (Point{1, 0}));
  EXPECT_EQ(FindFirstMeeting(Polyline{{0, 1}, {4, 1}}, other)->at, (Point{1, 1}));
  EXPECT_FALSE(FindFirstMeeting(Polyline{{0, 2}, {4, 2}}, other));
}

}  // namespace
}  // namespace tautline
