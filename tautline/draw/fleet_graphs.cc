#include "tautline/draw/fleet_graphs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "tautline/draw/fleet_layers.h"
#include "tautline/draw/text_metrics.h"

namespace tautline {
namespace {

constexpr double kVertexRadius = 14;
constexpr double kEventRadius = 9.5;
constexpr double kNameSize = 11;
constexpr double kLabelSize = 11;
constexpr double kHeadSize = 8.5;
constexpr double kBend = 0.12;  // Of an arrow's length: so that the way there and the way back part.

/// The style of arrows.
SvgStyle ArrowStyle(bool wrong) {
  return wrong ? SvgStyle{.stroke = kWarningColour, .width = 2.2} : SvgStyle{.stroke = kInkColour, .width = 1.3};
}

void DrawHead(SvgWriter& svg, Point tip, Point direction, const SvgStyle& style) {
  const Point unit = 1 / Norm(direction) * direction;
  svg.ArrowHead(tip - 0.5 * kHeadSize * unit, unit, kHeadSize, {.fill = style.stroke});
}

/// What an arrow looks like.
struct Arrow {
  double room = kVertexRadius;  ///< It keeps so far off both ends.
  double bend = kBend;          ///< To the left, as a part of its length.
  bool both = false;            ///< Heads at both ends.
  bool wrong = false;           ///< Red.
};

/// Draws an arrow from one point to another; where its middle is.
Point DrawArrow(SvgWriter& svg, Point from, Point to, const Arrow& arrow) {
  const Point way = to - from;
  const Point middle = Lerp(from, to, 0.5) + arrow.bend * Point{way.y, -way.x};
  const auto off = [&](Point end) { return end + arrow.room / Distance(end, middle) * (middle - end); };
  const Point tail = off(from), tip = off(to);
  const SvgStyle style = ArrowStyle(arrow.wrong);
  svg.Smooth(Polyline{tail, middle, tip}, style);
  DrawHead(svg, tip, tip - middle, style);
  if (arrow.both) DrawHead(svg, tail, tail - middle, style);
  return Lerp(middle, Lerp(tail, tip, 0.5), 0.5);
}

void DrawLabel(SvgWriter& svg, Point at, const std::string& text, const std::string& colour) {
  svg.Text({.at = at + Point{0, 0.36 * kLabelSize},
            .text = text,
            .size = kLabelSize,
            .anchor = TextAnchor::kMiddle,
            .bold = true,
            .fill = colour,
            .halo = kHaloColour});
}

/// Where the vertices of a graph stand.
std::vector<Point> OnCircle(const Box& frame, std::size_t count) {
  const double radius = 0.5 * std::min(frame.size().x, frame.size().y) - kVertexRadius - 8;
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (static_cast<double>(i) / static_cast<double>(count) - 0.25);
    points.push_back(frame.centre() + (count > 1 ? radius : 0) * Point{std::cos(angle), std::sin(angle)});
  }
  return points;
}

/// "A", or "A, C" where two robots cross several times.
void Join(std::string& labels, const std::string& label) { labels += (labels.empty() ? "" : ", ") + label; }

void DrawVertex(SvgWriter& svg, Point at, const std::string& name, const LineStyle& line, bool detour) {
  if (detour) svg.Circle(at, kVertexRadius + 3.5, {.stroke = kWarningColour, .width = 1.6, .dashes = "4 2"});
  svg.Circle(at, kVertexRadius, {.fill = kFreeColour, .stroke = line.colour, .width = 2.4});
  svg.Text({.at = at + Point{0, 0.36 * kNameSize},
            .text = Ellipsize(name, kNameSize, 2 * kVertexRadius - 3),
            .size = kNameSize,
            .anchor = TextAnchor::kMiddle,
            .bold = true});
}

}  // namespace

void DrawPairGraph(SvgWriter& svg, const Box& frame, const FleetGround& ground, const FleetPlan& plan) {
  const std::vector<Point> at = OnCircle(frame, ground.size());
  std::map<std::pair<RobotId, RobotId>, std::string> labels;
  for (const Passing& p : plan.passings) Join(labels[{p.first, p.second}], p.label);
  svg.OpenGroup("pair-graph");
  for (const PairDeadlock& pair : plan.pair_deadlocks) {
    DrawArrow(svg, at[pair.a.index()], at[pair.b.index()], {.bend = 0, .both = true, .wrong = true});
  }
  std::vector<std::pair<Point, std::string>> texts;
  texts.reserve(labels.size());
  for (const auto& [pair, label] : labels) {
    texts.emplace_back(DrawArrow(svg, at[pair.first.index()], at[pair.second.index()], {}), label);
  }
  for (const auto& [middle, label] : texts) DrawLabel(svg, middle, label, kInkColour);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const bool detour = std::find(plan.detours.begin(), plan.detours.end(), RobotId(i)) != plan.detours.end();
    DrawVertex(svg, at[i], ground.robots()[i].name, RobotLine(RobotId(i), at.size()), detour);
  }
  svg.CloseGroup();
}

EventGraphDrawing::EventGraphDrawing(const FleetPlan& plan) : chains_(plan.schedule.size()) {
  for (const Passing& p : plan.passings) {
    const std::size_t before = AddEvent(p.first.index(), p.first_along, p.label);
    orders_.emplace_back(before, AddEvent(p.second.index(), p.second_along, p.label));
  }
  for (auto& chain : chains_) {
    std::sort(chain.begin(), chain.end(),
              [&](std::size_t a, std::size_t b) { return events_[a].along < events_[b].along; });
    for (std::size_t i = 1; i < chain.size(); ++i) events_[chain[i - 1]].later.push_back(chain[i]);
  }
  for (const auto& [before, after] : orders_) events_[before].later.push_back(after);
  FindCircles();
  PlaceColumns();
}

/// Crossings at one place of a path are one event.
std::size_t EventGraphDrawing::AddEvent(std::size_t robot, double along, const std::string& label) {
  for (const std::size_t k : chains_[robot]) {
    if (events_[k].along != along) continue;
    Join(events_[k].label, label);
    return k;
  }
  chains_[robot].push_back(events_.size());
  events_.push_back({.robot = robot, .along = along, .label = label, .later = {}});
  return events_.size() - 1;
}

void EventGraphDrawing::FindCircles() {
  const std::size_t count = events_.size();
  reaches_.assign(count, std::vector<bool>(count));
  for (std::size_t start = 0; start < count; ++start) {
    std::vector<std::size_t> open = {start};
    while (!open.empty()) {
      const std::size_t k = open.back();
      open.pop_back();
      for (const std::size_t next : events_[k].later) {
        if (reaches_[start][next]) continue;
        reaches_[start][next] = true;
        open.push_back(next);
      }
    }
    events_[start].in_circle = reaches_[start][start];
  }
}

bool EventGraphDrawing::OnOneCircle(std::size_t a, std::size_t b) const { return reaches_[a][b] && reaches_[b][a]; }

bool EventGraphDrawing::has_circle() const {
  return std::any_of(events_.begin(), events_.end(), [](const Event& event) { return event.in_circle; });
}

/// Each event right of all that it waits for; on a circle, right of those before it on its own chain.
void EventGraphDrawing::PlaceColumns() {
  bool moved = true;
  for (std::size_t round = 0; moved && round <= events_.size(); ++round) {
    moved = false;
    for (std::size_t k = 0; k < events_.size(); ++k) {
      for (const std::size_t next : events_[k].later) {
        if (events_[k].robot != events_[next].robot && OnOneCircle(k, next)) continue;
        if (events_[next].column > events_[k].column) continue;
        events_[next].column = events_[k].column + 1;
        moved = true;
      }
    }
  }
  for (const Event& event : events_) columns_ = std::max(columns_, event.column + 1);
}

void EventGraphDrawing::Draw(SvgWriter& svg, const Box& frame, const FleetGround& ground) const {
  constexpr double kNames = 74, kEnds = 34;
  const double row = frame.size().y / static_cast<double>(std::max<std::size_t>(rows(), 1));
  const double column = (frame.size().x - kNames - 2 * kEnds) / static_cast<double>(columns_ + 1);
  const auto y = [&](std::size_t robot) { return frame.low.y + (static_cast<double>(robot) + 0.5) * row; };
  const double left = frame.low.x + kNames + kEnds, right = frame.high.x - kEnds;
  const auto at = [&](std::size_t k) {
    return Point{left + static_cast<double>(events_[k].column + 1) * column, y(events_[k].robot)};
  };
  svg.OpenGroup("event-graph");
  for (std::size_t i = 0; i < rows(); ++i) {
    Point last{left - 20, y(i)};
    svg.Text({.at = {frame.low.x, y(i) + 4}, .text = Ellipsize(ground.robots()[i].name, 12, kNames - 8), .bold = true});
    DrawMarker(svg, Marker::kStart, last, RobotLine(RobotId(i), rows()).colour);
    for (const std::size_t k : chains_[i]) {
      DrawArrow(svg, last, at(k), {.room = kEventRadius, .bend = 0});
      last = at(k);
    }
    const Point target{right, y(i)};
    DrawArrow(svg, last, target, {.room = kEventRadius, .bend = 0});
    DrawMarker(svg, Marker::kTarget, target, RobotLine(RobotId(i), rows()).colour);
  }
  for (const auto& [before, after] : orders_) {
    DrawArrow(svg, at(before), at(after), {.room = kEventRadius, .bend = 0.06, .wrong = OnOneCircle(before, after)});
  }
  for (std::size_t k = 0; k < events_.size(); ++k) {
    const Event& event = events_[k];
    const std::string edge = event.in_circle ? kWarningColour : RobotLine(RobotId(event.robot), rows()).colour;
    const double wide = std::max(kEventRadius, 0.5 * TextWidth(event.label, kLabelSize, true) + 3);
    svg.Rectangle({at(k) - Point{wide, kEventRadius}, at(k) + Point{wide, kEventRadius}},
                  {.fill = kFreeColour, .stroke = edge, .width = 1.8}, kEventRadius);
    DrawLabel(svg, at(k), event.label, event.in_circle ? kWarningColour : kInkColour);
  }
  svg.CloseGroup();
}

}  // namespace tautline
