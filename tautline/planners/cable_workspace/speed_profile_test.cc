#include "tautline/planners/cable_workspace/speed_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"

namespace tautline {
namespace {

TEST(SpeedProfile, OfConstantSpeedTakesLengthBySpeed) {
  const SpeedProfile profile(12, 3, {});
  EXPECT_EQ(profile.duration_s(), 4);
  EXPECT_EQ(profile.At(1).distance, 3);
  EXPECT_EQ(profile.At(0).speed, 3);
  EXPECT_EQ(profile.At(4).speed, 3);
  EXPECT_EQ(profile.TimeAt(6), 2);
}

TEST(SpeedProfile, SpeedsUpCruisesAndSlowsDown) {
  // Two seconds and 2 m each for the ramps, 6 m at 2 m/s between.
  const SpeedProfile profile(10, 2, 1);
  EXPECT_EQ(profile.duration_s(), 7);
  EXPECT_EQ(profile.top_speed(), 2);
  EXPECT_EQ(profile.At(1).speed, 1);
  EXPECT_EQ(profile.At(2).distance, 2);
  EXPECT_EQ(profile.At(3.5).distance, 5);
  EXPECT_EQ(profile.At(6).distance, 9.5);
  EXPECT_EQ(profile.At(7).speed, 0);
}

TEST(SpeedProfile, OfAShortPieceNeverReachesTheCruiseSpeed) {
  const SpeedProfile profile(4, 100, 1);
  EXPECT_EQ(profile.top_speed(), 2);
  EXPECT_EQ(profile.duration_s(), 4);
  EXPECT_EQ(profile.At(2).distance, 2);
}

TEST(SpeedProfile, OfNoLengthIsOverAtOnce) {
  const SpeedProfile profile(0, 3, 1);
  EXPECT_EQ(profile.duration_s(), 0);
  EXPECT_EQ(profile.At(0).speed, 0);
  EXPECT_EQ(profile.AtDistance(0).speed, 0);
  EXPECT_EQ(profile.TimeAt(0), 0);
}

TEST(SpeedProfile, SpeedAddsUpToTheLengthWithinTheAcceleration) {
  Rng rng(1);
  for (std::int64_t i = ScaledTestCount(200); i > 0; --i) {
    const double length = rng.Uniform(0.01, 30), cruise = rng.Uniform(0.1, 5), acceleration = rng.Uniform(0.05, 5);
    const bool constant = rng.UniformInt(0, 3) == 0;
    const SpeedProfile profile =
        constant ? SpeedProfile(length, cruise, {}) : SpeedProfile(length, cruise, acceleration);
    constexpr int kSteps = 2000;
    const double dt = profile.duration_s() / kSteps;
    double sum = 0;
    for (int k = 0; k < kSteps; ++k) {
      const auto a = profile.At(k * dt), b = profile.At((k + 1) * dt), middle = profile.At((k + 0.5) * dt);
      sum += middle.speed * dt;
      EXPECT_NEAR(sum, b.distance, 1e-3 * length);
      EXPECT_LE(b.speed, cruise);
      EXPECT_TRUE(constant || std::abs(b.speed - a.speed) <= acceleration * dt * (1 + 1e-9));
      EXPECT_NEAR(profile.TimeAt(middle.distance), (k + 0.5) * dt, 1e-6 * profile.duration_s());
      EXPECT_NEAR(profile.AtDistance(middle.distance).speed, middle.speed, 1e-6 * cruise);
    }
    EXPECT_NEAR(sum, length, std::min(acceleration * dt, cruise) * dt);
    EXPECT_EQ(profile.At(profile.duration_s()).distance, length);
  }
}

}  // namespace
}  // namespace tautline
