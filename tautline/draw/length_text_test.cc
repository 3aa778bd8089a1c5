#include "tautline/draw/length_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace tautline {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(LengthText, RoundsAndPads) {
  EXPECT_EQ(FixedText(12.3, 2), "12.30");
  EXPECT_EQ(FixedText(-0.004, 2), "0.00");
  EXPECT_EQ(FixedText(-1.005, 1), "-1.0");
  EXPECT_EQ(FixedText(7.5, 0), "8");
  EXPECT_EQ(FixedText(kNan, 2), "?");
}

TEST(LengthText, CompactHasNoTrailingZeros) {
  EXPECT_EQ(CompactText(12.30, 2), "12.3");
  EXPECT_EQ(CompactText(100, 2), "100");
  EXPECT_EQ(CompactText(-0.001, 2), "0");
  EXPECT_EQ(CompactText(kNan, 2), "0");
  EXPECT_EQ(CompactText(-kInfinity, 2), "0");
}

TEST(LengthText, DecimalsFollowTheWorld) {
  EXPECT_EQ(LengthDecimals(20), 2);
  EXPECT_EQ(LengthDecimals(2e6), 0);
  EXPECT_EQ(LengthDecimals(2e-3), 6);
  EXPECT_EQ(LengthDecimals(0), 2);
}

TEST(LengthText, TellsNearLengthsApart) {
  EXPECT_EQ(DecimalsToTellApart(18.0004, 18, 2), 4);
  EXPECT_EQ(DecimalsToTellApart(18, 18, 2), 2);
  EXPECT_EQ(DecimalsToTellApart(18, 19, 2), 2);
}

TEST(LengthText, Areas) {
  EXPECT_EQ(AreaText(384.76), "384.8 m²");
  EXPECT_EQ(AreaText(7201.4), "7201 m²");
  EXPECT_EQ(AreaText(0.00123456), "0.001235 m²");
  EXPECT_EQ(AreaText(0), "0 m²");
}

TEST(LengthText, RoundLengths) {
  EXPECT_EQ(RoundLengthText(RoundLengthBelow(7.3)), "5 m");
  EXPECT_EQ(RoundLengthText(RoundLengthBelow(5)), "5 m");
  EXPECT_EQ(RoundLengthText(RoundLengthBelow(1000)), "1 km");
  EXPECT_EQ(RoundLengthText(RoundLengthBelow(0.37)), "20 cm");
  EXPECT_EQ(RoundLengthText(RoundLengthBelow(0.0029)), "2 mm");
  EXPECT_EQ(RoundLengthText(RoundLengthBelow(0.00007)), "50 µm");
}

}  // namespace
}  // namespace tautline
