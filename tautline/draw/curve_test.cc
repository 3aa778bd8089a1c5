#include "tautline/draw/curve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tautline {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

const Polyline kBend = {{0, 0}, {10, 0}, {10, 10}};

TEST(PositionAlong, FollowsTheLineAndStopsAtItsEnds) {
  EXPECT_EQ(PositionAlong(kBend, 4).at, (Point{4, 0}));
  EXPECT_EQ(PositionAlong(kBend, 15).at, (Point{10, 5}));
  EXPECT_EQ(PositionAlong(kBend, 15).direction, (Point{0, 1}));
  EXPECT_EQ(PositionAlong(kBend, -3).at, (Point{0, 0}));
  EXPECT_EQ(PositionAlong(kBend, 99).at, (Point{10, 10}));
}

TEST(PartOf, KeepsTheCornersBetween) {
  EXPECT_THAT(PartOf(kBend, 5, 15), ElementsAre(Point{5, 0}, Point{10, 0}, Point{10, 5}));
  EXPECT_THAT(PartOf(kBend, 12, 15), ElementsAre(Point{10, 2}, Point{10, 5}));
}

TEST(RunSideBySide, LonelyLinesStay) {
  const std::vector<Polyline> lines = {kBend, {{0, 5}, {5, 5}}};
  EXPECT_EQ(RunSideBySide(lines, 4), lines);
}

TEST(RunSideBySide, SharedEdgesPart) {
  const std::vector<Polyline> lines = {{{0, 0}, {10, 0}}, {{10, 0}, {0, 0}}};
  const std::vector<Polyline> moved = RunSideBySide(lines, 4);
  EXPECT_THAT(moved[0], ElementsAre(Point{0, -2}, Point{10, -2}));
  EXPECT_THAT(moved[1], ElementsAre(Point{10, 2}, Point{0, 2}));
}

TEST(RunSideBySide, CornersAreMitred) {
  const std::vector<Polyline> moved = RunSideBySide(std::vector<Polyline>{kBend, kBend}, 2);
  EXPECT_THAT(moved[1], ElementsAre(Point{0, 1}, Point{9, 1}, Point{9, 10}));
}

TEST(DrawCurve, CasedLinesAreDrawnTwice) {
  SvgWriter svg({.width = 100, .height = 100});
  DrawCurve(svg, kBend, {.colour = "#abcdef", .width = 6, .casing = "#123456"});
  const std::string text = svg.Finish();
  EXPECT_THAT(text, HasSubstr("#123456"));
  EXPECT_THAT(text, HasSubstr("#abcdef"));
}

TEST(DrawCurve, PointsDrawNothing) {
  SvgWriter svg({.width = 100, .height = 100});
  const Polyline point = {{5, 5}, {5, 5}};
  DrawCurve(svg, point, {.colour = "#abcdef", .wavy = true, .arrows = true});
  EXPECT_THAT(svg.Finish(), Not(HasSubstr("<path")));
}

}  // namespace
}  // namespace tautline
