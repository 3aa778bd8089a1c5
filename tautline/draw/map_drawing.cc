#include "tautline/draw/map_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tautline/draw/curve.h"
#include "tautline/draw/obstacle_names.h"
#include "tautline/draw/text_metrics.h"

namespace tautline {
namespace {

constexpr double kLabelSize = 12.5;
constexpr double kLabelLine = 15.5;
constexpr double kFartherCost = 0.15;  // For each next place of a label that is farther off.
constexpr double kSmallIsland = 0.35;  // Of the map's width and height.

/// Points beside a line from its middle outwards, such that a label of `size` there keeps off the
/// line.
std::vector<Point> CentresBeside(std::span<const Point> line, Point size) {
  constexpr double kStep = 14;
  constexpr double kDistance = 7;
  const double length = Length(line);
  std::vector<Point> centres;
  for (double offset = 0; offset <= 0.3 * length + 1; offset += kStep) {
    for (const double side : {1.0, -1.0}) {
      const CurvePosition position = PositionAlong(line, 0.5 * length + side * offset);
      const Point normal{-position.direction.y, position.direction.x};
      const double away = kDistance + 0.5 * (std::abs(normal.x) * size.x + std::abs(normal.y) * size.y);
      centres.push_back(position.at + away * normal);
      centres.push_back(position.at - away * normal);
    }
  }
  return centres;
}

/// Points about a point, from it outwards.
std::vector<Point> CentresAbout(Point middle, bool beside) {
  constexpr int kDirections = 8;
  constexpr double kStep = 16;
  std::vector<Point> centres;
  if (!beside) centres.push_back(middle);
  for (const double radius : {kStep, 2 * kStep, 3 * kStep}) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2 * std::numbers::pi * i / kDirections;
      centres.push_back(middle + radius * Point{std::cos(angle), std::sin(angle)});
    }
  }
  return centres;
}

/// Points on a line from its middle outwards.
std::vector<Point> CentresOn(std::span<const Point> line) {
  constexpr double kStep = 9;
  const double length = Length(line);
  std::vector<Point> centres;
  for (double offset = 0; offset <= 0.5 * length - kBadgeRadius; offset += kStep) {
    centres.push_back(PositionAlong(line, 0.5 * length + offset).at);
    centres.push_back(PositionAlong(line, 0.5 * length - offset).at);
  }
  if (centres.empty() && !line.empty()) centres.push_back(PositionAlong(line, 0.5 * length).at);
  return centres;
}

std::vector<std::string> SplitLines(const std::string& text) {
  std::vector<std::string> lines(1);
  for (const char c : text) {
    if (c == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += c;
    }
  }
  return lines;
}

Point LabelSize(const std::string& text) {
  Point size{0, 0};
  for (const std::string& line : SplitLines(text)) {
    size = {std::max(size.x, TextWidth(line, kLabelSize, true) + 2), size.y + kLabelLine};
  }
  return size;
}

void AppendLabel(const Box& box, const std::string& text, const std::string& colour, std::vector<SvgText>& texts) {
  double y = box.low.y + 0.5 * kLabelLine + 0.36 * kLabelSize;
  for (const std::string& line : SplitLines(text)) {
    texts.push_back({.at = {box.centre().x, y},
                     .text = line,
                     .size = kLabelSize,
                     .anchor = TextAnchor::kMiddle,
                     .bold = true,
                     .fill = colour,
                     .halo = kHaloColour});
    y += kLabelLine;
  }
}

}  // namespace

MapDrawing::MapDrawing(SvgWriter& svg, const MapGround& map)
    : space_(map.space), frame_(map.options.frame), view_(map.view), svg_(svg), placer_(frame_) {
  DrawGround(svg_, view_, map.world, space_, map.options);
  if (!IsOpenPlane(map.world)) DiscourageGround();
}

/// Labels keep off small islands, whose names they would seem to be, and off the rim of the world.
void MapDrawing::DiscourageGround() {
  const Box& map = frame_;
  for (const FreeComponent& component : space_.components) {
    for (const BoundaryRing& hole : component.holes) {
      const Box box = BoundingBox(view_.ToPixels(hole.points));
      if (box.size().x < kSmallIsland * map.size().x && box.size().y < kSmallIsland * map.size().y) {
        placer_.Discourage(box);
      }
    }
  }
  const Point low = view_.ToPixels({space_.box.low.x, space_.box.high.y});
  const Point high = view_.ToPixels({space_.box.high.x, space_.box.low.y});
  placer_.Discourage({map.low, {low.x, map.high.y}});
  placer_.Discourage({{high.x, map.low.y}, map.high});
  placer_.Discourage({map.low, {map.high.x, low.y}});
  placer_.Discourage({{map.low.x, high.y}, map.high});
}

void MapDrawing::Line(std::string_view layer, std::span<const Point> line, const LineStyle& style) {
  PixelLine(layer, view_.ToPixels(line), style);
}

void MapDrawing::PixelLine(std::string_view layer, std::span<const Point> line, const LineStyle& style) {
  svg_.OpenWindow(layer, frame_);
  DrawCurve(svg_, line, style);
  svg_.CloseWindow();
  placer_.TakeLine(line);
}

void MapDrawing::Shape(std::string_view layer, std::span<const SvgCurve> curves, const SvgStyle& style) {
  if (curves.empty()) return;
  svg_.OpenWindow(layer, frame_);
  svg_.Curves(curves, style);
  svg_.CloseWindow();
}

void MapDrawing::Rays(const std::set<ObstacleId>& islands) {
  for (const ObstacleId id : islands) {
    const Point foot = view_.ToPixels(space_.islands[id.index()].representative);
    PixelLine("ray", Polyline{foot, {foot.x, frame_.low.y}}, kRayLine);
    svg_.Circle(foot, 2, {.fill = kRayLine.colour});
  }
}

Point MapDrawing::OnMap(Point at) const {
  const Point pixel = view_.ToPixels(at);
  const Box& map = frame_;
  return {std::clamp(pixel.x, map.low.x, map.high.x), std::clamp(pixel.y, map.low.y, map.high.y)};
}

void MapDrawing::Mark(Marker marker, Point at, const std::string& label, const std::string& colour) {
  const Point pixel = OnMap(at);
  const bool outside = Distance(pixel, view_.ToPixels(at)) > 1;
  marks_.push_back({marker, pixel, outside && !label.empty() ? label + " (outside)" : label, colour});
}

void MapDrawing::LabelLine(std::span<const Point> line, const std::string& label, const std::string& colour) {
  line_labels_.push_back({view_.ToPixels(line), label, colour});
}

void MapDrawing::LabelPoint(Point at, const std::string& label, double room) {
  const bool beside = room * view_.pixels_per_metre() < 1.5 * kLabelLine;
  line_labels_.push_back({{OnMap(at)}, label, kInkColour, beside});
}

void MapDrawing::Number(std::span<const Point> line, const std::string& number, const std::string& colour) {
  numbers_.push_back({Polyline(line.begin(), line.end()), number, colour});
}

void MapDrawing::Name(const std::set<ObstacleId>& islands) { named_.insert(islands.begin(), islands.end()); }

void MapDrawing::Finish() {
  std::vector<SvgText> texts;
  for (const PendingMark& mark : marks_) placer_.Take(MarkerBox(mark.marker, mark.at));
  DrawNumbers();
  PlaceMarkLabels(texts);
  PlaceLineLabels(texts);
  const std::vector<SvgText> names = PlaceObstacleNames(space_, view_, named_, placer_);
  svg_.OpenGroup("names");
  for (const SvgText& name : names) svg_.Text(name);
  svg_.CloseGroup();
  DrawMarks();
  svg_.OpenGroup("labels");
  for (const SvgText& text : texts) svg_.Text(text);
  svg_.CloseGroup();
}

void MapDrawing::DrawNumbers() {
  if (numbers_.empty()) return;
  const Point size{2 * kBadgeRadius + 2, 2 * kBadgeRadius + 2};
  svg_.OpenGroup("numbers");
  for (const PendingLabel& number : numbers_) {
    const Box box = placer_.FindAt(CentresOn(number.line), size).box;
    placer_.Take(box);
    DrawBadge(svg_, number.text, box.centre(), number.colour);
  }
  svg_.CloseGroup();
}

void MapDrawing::DrawMarks() {
  svg_.OpenGroup("markers");
  for (const PendingMark& mark : marks_) DrawMarker(svg_, mark.marker, mark.at, mark.colour);
  svg_.CloseGroup();
}

void MapDrawing::PlaceMarkLabels(std::vector<SvgText>& texts) {
  for (const PendingMark& mark : marks_) {
    if (mark.label.empty()) continue;
    const Box box = placer_.FindBeside(MarkerBox(mark.marker, mark.at), LabelSize(mark.label)).box;
    placer_.Take(box);
    AppendLabel(box, mark.label, kInkColour, texts);
  }
}

void MapDrawing::PlaceLineLabels(std::vector<SvgText>& texts) {
  for (const PendingLabel& label : line_labels_) {
    const Point size = LabelSize(label.text);
    const std::vector<Point> centres =
        label.line.size() > 1 ? CentresBeside(label.line, size) : CentresAbout(label.line[0], label.beside);
    const Box box = placer_.FindAt(centres, size, kFartherCost).box;
    placer_.Take(box);
    AppendLabel(box, label.text, label.colour, texts);
  }
}

}  // namespace tautline
