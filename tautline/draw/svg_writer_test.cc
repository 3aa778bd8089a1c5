#include "tautline/draw/svg_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "tautline/draw/xml_check.h"

namespace tautline {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(EscapeXml, SpecialCharacters) {
  EXPECT_EQ(EscapeXml("a<b & \"c\" > 'd'"), "a&lt;b &amp; &quot;c&quot; &gt; &#39;d&#39;");
  EXPECT_EQ(EscapeXml("Maß 北"), "Maß 北");
}

TEST(EscapeXml, ReplacesWhatXmlCannotHold) {
  EXPECT_EQ(EscapeXml(std::string("a\0b", 3)),
            "a\xEF\xBF\xBD"
            "b");
  EXPECT_EQ(EscapeXml("\x1b[1m"), "\xEF\xBF\xBD[1m");
  EXPECT_EQ(EscapeXml("\xC3"), "\xEF\xBF\xBD");                                  // Cut short.
  EXPECT_EQ(EscapeXml("\xC0\xAF"), "\xEF\xBF\xBD\xEF\xBF\xBD");                  // Overlong.
  EXPECT_EQ(EscapeXml("\xEF\xBF\xBF"), "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD");  // Not a character.
}

TEST(SvgWriter, WritesRelativeMovesOnAGrid) {
  SvgWriter svg({.width = 100, .height = 50, .decimals = 1});
  const Polyline line = {{10, 10}, {20.04, 10}, {20.04, 30}, {15, 35.5}};
  svg.Polyline(line, {.stroke = "red"});
  EXPECT_THAT(svg.Finish(), HasSubstr("d=\"M10 10h10v20l-5 5.5\""));
}

TEST(SvgWriter, KeepsArcs) {
  SvgWriter svg({.width = 100, .height = 50, .decimals = 1});
  const SvgCurve quarter{
      .start = {10, 20}, .steps = {{{20, 10}, 10, false}, {{20, 20}}, {{20, 20.01}, 3}, {{10, 20}}}, .closed = true};
  const SvgCurve dot{.start = {1, 1}, .steps = {{{1, 1.01}, 5}}};
  svg.Curves(std::vector{quarter, dot}, {.fill = "red", .opacity = 0.25});
  const std::string text = svg.Finish();
  EXPECT_THAT(text, HasSubstr("d=\"M10 20a10 10 0 0 1 10-10v10h-10zM1 1h0\""));
  EXPECT_THAT(text, HasSubstr("fill=\"red\" fill-opacity=\"0.25\""));
}

TEST(SvgWriter, HolesByTheEvenOddRule) {
  SvgWriter svg({.width = 100, .height = 50});
  const Ring rings[] = {{{0, 0}, {9, 0}, {9, 9}}, {{2, 1}, {8, 1}, {8, 7}}};
  svg.Polygon(rings, {.fill = "red"});
  EXPECT_THAT(svg.Finish(), HasSubstr("d=\"M0 0h9v9zM2 1h6v6z\" fill-rule=\"evenodd\""));
}

TEST(SvgWriter, TinyRingsBecomeDots) {
  SvgWriter svg({.width = 100, .height = 50});
  const Ring speck = {{5, 5}, {5.001, 5}, {5.001, 5.001}};
  svg.Polygon({&speck, 1}, {.fill = "red"});
  EXPECT_THAT(svg.Finish(), HasSubstr("d=\"M5 5h0\""));
}

TEST(SvgWriter, LeavesOutWhatIsNotFinite) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  SvgWriter svg({.width = 100, .height = 50});
  const Polyline line = {{0, 0}, {kNan, 1}, {kInfinity, 2}, {3, 3}};
  svg.Polyline(line, {.stroke = "red"});
  svg.Smooth(line, {.stroke = "red"});
  svg.Circle({kNan, 0}, 1, {.fill = "red"});
  svg.Text({.at = {0, kInfinity}, .text = "gone"});
  const std::string text = svg.Finish();
  EXPECT_THAT(text, HasSubstr("d=\"M0 0l3 3\""));
  EXPECT_THAT(text, Not(HasSubstr("gone")));
  EXPECT_THAT(text, Not(HasSubstr("nan")));
  EXPECT_EQ(XmlCheck(text).error(), "");
}

TEST(SvgWriter, EscapesTextAndLayers) {
  SvgWriter svg({.width = 100, .height = 50, .title = "<&\">"});
  svg.OpenGroup("a\"b");
  svg.Text({.at = {1, 2}, .text = "<&\">", .bold = true, .halo = "white"});
  svg.CloseGroup();
  const std::string text = svg.Finish();
  EXPECT_EQ(XmlCheck(text).error(), "");
  EXPECT_THAT(text, HasSubstr("<title>&lt;&amp;&quot;&gt;</title>"));
  EXPECT_THAT(text, HasSubstr(">&lt;&amp;&quot;&gt;</text>"));
}

TEST(SvgWriter, GroupsMustBeClosed) {
  SvgWriter svg({.width = 100, .height = 50});
  EXPECT_THROW(svg.CloseGroup(), std::logic_error);
  svg.OpenGroup("open");
  EXPECT_THROW(svg.Finish(), std::logic_error);
}

TEST(XmlCheck, FindsFaults) {
  EXPECT_EQ(XmlCheck("<a b=\"1\"><c/>text &amp; more</a>").error(), "");
  EXPECT_NE(XmlCheck("<a><c></a>").error(), "");
  EXPECT_NE(XmlCheck("<a>&nope;</a>").error(), "");
  EXPECT_NE(XmlCheck("<a b=\"<\"/>").error(), "");
  EXPECT_NE(XmlCheck("<a b=\"1\" b=\"2\"/>").error(), "");
  EXPECT_NE(XmlCheck("<a/><b/>").error(), "");
  EXPECT_NE(XmlCheck("<a>").error(), "");
}

}  // namespace
}  // namespace tautline
