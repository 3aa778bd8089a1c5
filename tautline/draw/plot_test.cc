#include "tautline/draw/plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tautline/base/rng.h"
#include "tautline/draw/xml_check.h"

namespace tautline {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

std::string Draw(const PlotContent& content) {
  SvgWriter svg({.width = 600, .height = 240, .title = "plot"});
  DrawPlot(svg, {{10, 10}, {590, 230}}, content);
  return svg.Finish();
}

TEST(RoundTicks, AreRoundAndWithinTheRange) {
  EXPECT_THAT(RoundTicks(0, 10, 5), ElementsAre(0, 2, 4, 6, 8, 10));
  EXPECT_THAT(RoundTicks(-1, 1, 4), ElementsAre(-1, -0.5, 0, 0.5, 1));
  EXPECT_THAT(RoundTicks(0.1, 0.9, 2), ElementsAre(0.5));
}

TEST(RoundTicks, AreAboutAsManyAsAskedFor) {
  Rng rng(31);
  for (int i = 0; i < 1000; ++i) {
    const double low = rng.Uniform(-1, 1) * std::pow(10, rng.UniformInt(-4, 5));
    const double high = low + rng.Uniform(0.1, 1) * std::pow(10, rng.UniformInt(-4, 5));
    const int count = rng.UniformInt(2, 12);
    const auto ticks = RoundTicks(low, high, count);
    EXPECT_LE(ticks.size(), 1.5 * count + 2) << low << " to " << high;
    EXPECT_GE(ticks.size(), std::floor(0.5 * count)) << low << " to " << high;
    for (std::size_t k = 0; k < ticks.size(); ++k) {
      EXPECT_GE(ticks[k], low - 1e-6 * (high - low));
      EXPECT_LE(ticks[k], high + 1e-6 * (high - low));
    }
  }
}

TEST(DrawPlot, HasTitleLabelsNamesTicksAndMarks) {
  const std::string svg =
      Draw({.title = "Lengths",
            .x_label = "time (s)",
            .y_label = "metres",
            .series = {{"one", {}, {{{0, 0}, {10, 4}}}, {{5, 2}}}, {"two", {}, {{{0, 4}, {10, 4}}}}},
            .events = {{5, "turn"}},
            .levels = {{3, "limit"}}});
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(svg, AllOf(HasSubstr(">Lengths<"), HasSubstr(">time (s)<"), HasSubstr(">metres<"), HasSubstr(">one<"),
                         HasSubstr(">two<"), HasSubstr(">turn<"), HasSubstr(">limit<"), HasSubstr("<circle")));
}

TEST(DrawPlot, OfNothingAndOfOneValueHasAxes) {
  for (const std::vector<Polyline>& parts :
       {std::vector<Polyline>{}, {{}}, {{{2, 3}}}, {{{2, 3}, {2, 3}}}, {{{0, std::nan("")}, {1, 1}}}}) {
    const std::string svg = Draw({.title = "t", .x_label = "x", .y_label = "y", .series = {{"name", {}, parts}}});
    EXPECT_EQ(XmlCheck(svg).error(), "");
    EXPECT_THAT(svg, AllOf(Not(HasSubstr("nan")), Not(HasSubstr("inf"))));
  }
}

/// The y of the text in the picture.
double HeightOf(const std::string& svg, const std::string& text) {
  const std::size_t at = svg.rfind(" y=\"", svg.find(">" + text + "<"));
  return std::stod(svg.substr(at + 4));
}

TEST(DrawPlot, NamesOfCurvesThatEndTogetherStandApart) {
  PlotContent content{.title = "t", .x_label = "x", .y_label = "y"};
  for (int i = 0; i < 5; ++i) content.series.push_back({"name" + std::to_string(i), {}, {{{0, i * 1.0}, {1, 2}}}});
  const std::string svg = Draw(content);
  for (int i = 0; i < 5; ++i) {
    for (int k = 0; k < i; ++k) {
      EXPECT_GE(std::abs(HeightOf(svg, "name" + std::to_string(i)) - HeightOf(svg, "name" + std::to_string(k))), 13);
    }
  }
}

}  // namespace
}  // namespace tautline
