#include "tautline/draw/marker.h"

#include <cmath>
#include <numbers>

#include "tautline/draw/line_style.h"

namespace tautline {
namespace {

void DrawSocket(SvgWriter& svg, Point at) {
  svg.Rectangle({at - Point{8, 8}, at + Point{8, 8}}, {.fill = kInkColour, .stroke = kHaloColour, .width = 1.5}, 3);
  svg.Circle(at, 5.2, {.fill = kHaloColour});
  svg.Circle(at - Point{2, 0}, 1.2, {.fill = kInkColour});
  svg.Circle(at + Point{2, 0}, 1.2, {.fill = kInkColour});
}

void DrawFlag(SvgWriter& svg, Point at) {
  const Ring cloth = {at + Point{0, -20}, at + Point{14, -15.5}, at + Point{0, -11}};
  const Polyline pole = {at, at + Point{0, -20}};
  svg.Polyline(pole, {.stroke = kHaloColour, .width = 5});
  svg.Polygon({&cloth, 1}, {.fill = "#cc2f5e", .stroke = kHaloColour, .width = 4});
  svg.Polygon({&cloth, 1}, {.fill = "#cc2f5e", .stroke = kInkColour});
  svg.Polyline(pole, {.stroke = kInkColour, .width = 2});
  svg.Circle(at, 3.2, {.fill = kInkColour, .stroke = kHaloColour});
}

void DrawForbidden(SvgWriter& svg, Point at) {
  const Polyline bar = {at + Point{-7, 7}, at + Point{7, -7}};
  svg.Circle(at, 10, {.stroke = kHaloColour, .width = 5.5});
  svg.Circle(at, 10, {.stroke = kWarningColour, .width = 3});
  svg.Polyline(bar, {.stroke = kWarningColour, .width = 3});
}

void DrawCross(SvgWriter& svg, Point at) {
  const Polyline arms[] = {{at + Point{-5, -5}, at + Point{5, 5}}, {at + Point{-5, 5}, at + Point{5, -5}}};
  svg.Polylines(arms, {.stroke = kHaloColour, .width = 6});
  svg.Polylines(arms, {.stroke = kWarningColour, .width = 3});
}

void DrawDiamond(SvgWriter& svg, Point at) {
  const Ring diamond = {at + Point{0, -5}, at + Point{5, 0}, at + Point{0, 5}, at + Point{-5, 0}};
  svg.Polygon({&diamond, 1}, {.stroke = kHaloColour, .width = 3.5});
  svg.Polygon({&diamond, 1}, {.stroke = kWarningColour, .width = 1.6});
}

void DrawDrum(SvgWriter& svg, Point at) {
  svg.Circle(at, 7, {.fill = kInkColour, .stroke = kHaloColour, .width = 1.5});
  svg.Circle(at, 4, {.stroke = kHaloColour, .width = 1.4});
  svg.Circle(at, 1.4, {.fill = kHaloColour});
}

void DrawTask(SvgWriter& svg, Point at) {
  svg.Rectangle({at - Point{4.5, 4.5}, at + Point{4.5, 4.5}}, {.fill = "#7b3fa0", .stroke = kHaloColour, .width = 1.5},
                1);
}

void DrawStar(SvgWriter& svg, Point at) {
  constexpr int kPoints = 5;
  Ring star;
  for (int i = 0; i < 2 * kPoints; ++i) {
    const double radius = i % 2 == 0 ? 8.5 : 3.6, angle = std::numbers::pi * (0.5 + static_cast<double>(i) / kPoints);
    star.push_back(at + radius * Point{std::cos(angle), -std::sin(angle)});
  }
  svg.Polygon({&star, 1}, {.fill = "#cc2f5e", .stroke = kHaloColour, .width = 3});
  svg.Polygon({&star, 1}, {.fill = "#cc2f5e", .stroke = kInkColour, .width = 0.8});
}

}  // namespace

void DrawMarker(SvgWriter& svg, Marker marker, Point at, const std::string& colour) {
  const std::string fill = colour.empty() ? kInkColour : colour;
  switch (marker) {
    case Marker::kBase:
      return DrawSocket(svg, at);
    case Marker::kRobot:
      svg.Circle(at, 7, {.fill = "#0b4a8f", .stroke = kHaloColour, .width = 1.5});
      return svg.Circle(at, 2.6, {.fill = kHaloColour});
    case Marker::kGoal:
      return DrawFlag(svg, at);
    case Marker::kPoint:
      return svg.Circle(at, 4.5, {.fill = kHaloColour, .stroke = kInkColour, .width = 2});
    case Marker::kBlocked:
      return DrawForbidden(svg, at);
    case Marker::kTetherEnd:
      return DrawCross(svg, at);
    case Marker::kSnap:
      return DrawDiamond(svg, at);
    case Marker::kWinch:
      return DrawDrum(svg, at);
    case Marker::kTask:
      return DrawTask(svg, at);
    case Marker::kStart:
      return svg.Rectangle({at - Point{5, 5}, at + Point{5, 5}}, {.fill = fill, .stroke = kHaloColour, .width = 1.4});
    case Marker::kTarget:
      svg.Circle(at, 6.8, {.fill = kHaloColour});
      return svg.Circle(at, 4.8, {.fill = kHaloColour, .stroke = fill, .width = 2.4});
    case Marker::kCrossing:
      return svg.Circle(at, 2.8, {.fill = kInkColour, .stroke = kHaloColour, .width = 0.8});
    case Marker::kRing:
      svg.Circle(at, 12, {.stroke = kHaloColour, .width = 5});
      return svg.Circle(at, 12, {.stroke = kWarningColour, .width = 2.6});
    case Marker::kStar:
      return DrawStar(svg, at);
  }
}

Box MarkerBox(Marker marker, Point at) {
  switch (marker) {
    case Marker::kBase:
      return {at - Point{9, 9}, at + Point{9, 9}};
    case Marker::kGoal:
      return {at - Point{5, 22}, at + Point{15, 5}};
    case Marker::kBlocked:
      return {at - Point{12, 12}, at + Point{12, 12}};
    case Marker::kRing:
      return {at - Point{14, 14}, at + Point{14, 14}};
    case Marker::kCrossing:
      return {at - Point{3, 3}, at + Point{3, 3}};
    default:
      return {at - Point{8, 8}, at + Point{8, 8}};
  }
}

void DrawBadge(SvgWriter& svg, const std::string& number, Point at, const std::string& colour) {
  svg.Circle(at, kBadgeRadius, {.fill = kHaloColour, .stroke = colour, .width = 1.8});
  svg.Text({.at = at + Point{0, 3.6}, .text = number, .size = 10, .anchor = TextAnchor::kMiddle, .bold = true});
}

}  // namespace tautline
