#include "tautline/scene/number_text.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstdlib>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"

namespace tautline {
namespace {

TEST(ParseNumber, ReadsDecimalNumbers) {
  EXPECT_EQ(ParseNumber("0"), 0.0);
  EXPECT_EQ(ParseNumber("-12"), -12.0);
  EXPECT_EQ(ParseNumber("+3."), 3.0);
  EXPECT_EQ(ParseNumber(".25"), 0.25);
  EXPECT_EQ(ParseNumber("1e-3"), 1e-3);
  EXPECT_EQ(ParseNumber("6.02E+23"), 6.02e23);
  EXPECT_EQ(ParseNumber("0.1"), 0.1);
  EXPECT_EQ(ParseNumber("123456789012345678901234567890"), 123456789012345678901234567890.0);
  EXPECT_EQ(ParseNumber("1e400"), INFINITY);
  EXPECT_EQ(ParseNumber("-1e400"), -INFINITY);
  EXPECT_EQ(ParseNumber("1e-400"), 0.0);
}

TEST(ParseNumber, RefusesEverythingElse) {
  for (const char* text : {"", ".", "-", "e5", "1e", "1e+", "0x10", "1,5", " 1", "1 ", "inf", "nan", "1.2.3", "--1"}) {
    EXPECT_EQ(ParseNumber(text), std::nullopt) << text;
  }
}

TEST(ParseNumber, IgnoresTheLocale) {
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  std::setlocale(LC_NUMERIC, "de_DE.UTF-8");  // Where it is not installed the test is weaker, not wrong.
  EXPECT_EQ(ParseNumber("2.5"), 2.5);
  EXPECT_EQ(ParseNumber("123456789012345678.5"), 123456789012345678.5);
  EXPECT_EQ(FormatNumber(2.5), "2.5");
  std::setlocale(LC_NUMERIC, before.c_str());
}

TEST(FormatNumber, IsShort) {
  EXPECT_EQ(FormatNumber(0.1), "0.1");
  EXPECT_EQ(FormatNumber(-3), "-3");
  EXPECT_EQ(FormatNumber(1234.5678), "1234.5678");
}

TEST(FormatNumber, ReadsBackTheSameNumber) {
  Rng rng(5);
  for (int i = 0; i < ScaledTestCount(5000); ++i) {
    const double value = rng.Uniform(-1, 1) * std::pow(10, rng.UniformInt(-30, 30));
    EXPECT_EQ(ParseNumber(FormatNumber(value)), value);
  }
}

TEST(ParseNumber, AgreesWithTheStandardLibrary) {
  Rng rng(6);
  for (int i = 0; i < ScaledTestCount(5000); ++i) {
    const std::string text = std::to_string(rng.Next() % 1000000) + "." + std::to_string(rng.Next() >> 20) + "e" +
                             std::to_string(rng.UniformInt(-30, 30));
    EXPECT_EQ(ParseNumber(text), std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(ShortNumber, HasFourDecimals) {
  EXPECT_EQ(ShortNumber(74.34123456), "74.3412");
  EXPECT_EQ(ShortNumber(1234.56785678), "1234.5679");
  EXPECT_EQ(ShortNumber(6.79348), "6.7935");
  EXPECT_EQ(ShortNumber(0.01177661), "0.0117766");
  EXPECT_EQ(ShortNumber(-2.50), "-2.5");
  EXPECT_EQ(ShortNumber(1e12), "1e+12");
  EXPECT_EQ(ShortNumber(-6.1e-17), "0");
  EXPECT_EQ(Metres(18), "18 m");
  EXPECT_EQ(ShortText({4.0 / 3, -2}), "(1.3333, -2)");
}

}  // namespace
}  // namespace tautline
