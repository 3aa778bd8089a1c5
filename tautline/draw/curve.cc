#include "tautline/draw/curve.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace tautline {
namespace {

constexpr double kHalfWave = 5.5;        // Pixels between neighbouring crests of slack cable.
constexpr double kWaveHeight = 4.5;      // Of the control polygon; the curve is half as high.
constexpr double kLongestWave = 40'000;  // Pixels; longer cables are drawn straight, to keep the file small.
constexpr double kArrowSpacing = 120;
constexpr double kArrowSize = 11;
constexpr double kArrowMargin = 17;    // From the corners of the line.
constexpr double kLargestBundle = 26;  // Pixels across all lines on one shared edge.

/// Between the ends of a segment, or pulled to its middle when it is short: arrow heads keep off
/// the corners.
double AwayFromCorners(double along, double length) {
  return length < 2 * kArrowMargin ? 0.5 * length : std::clamp(along, kArrowMargin, length - kArrowMargin);
}

void DrawArrows(SvgWriter& svg, std::span<const Point> line, const LineStyle& style) {
  const double length = Length(line);
  const int count = std::clamp(static_cast<int>(std::lround(length / kArrowSpacing)), 1, 40);
  double before = 0;
  int next = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double segment = Distance(line[i - 1], line[i]);
    for (; next < count && (next + 0.5) * length / count <= before + segment; ++next) {
      if (segment < 1.5 * kArrowSize) continue;
      const double along = AwayFromCorners((next + 0.5) * length / count - before, segment);
      svg.ArrowHead(Lerp(line[i - 1], line[i], along / segment), line[i] - line[i - 1], kArrowSize,
                    {.fill = style.colour, .stroke = kHaloColour, .width = 0.8});
    }
    before += segment;
  }
}

/// The control polygon of a wave about the line.
Polyline Wave(std::span<const Point> line) {
  Polyline wave = {line.front()};
  const double length = Length(line);
  double before = 0, side = 1;
  double next = kHalfWave;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double segment = Distance(line[i - 1], line[i]);
    for (; next <= before + segment && next < length - 0.5 * kHalfWave; next += kHalfWave) {
      const Point direction = 1 / segment * (line[i] - line[i - 1]);
      wave.push_back(Lerp(line[i - 1], line[i], (next - before) / segment) +
                     side * kWaveHeight * Point{-direction.y, direction.x});
      side = -side;
    }
    before += segment;
  }
  wave.push_back(line.back());
  return wave;
}

using EdgeKey = std::pair<Point, Point>;

EdgeKey Undirected(Point a, Point b) { return a < b ? EdgeKey{a, b} : EdgeKey{b, a}; }

/// Which lines use an edge, each once, in their order.
using EdgeUsers = std::map<EdgeKey, std::vector<std::size_t>>;

EdgeUsers FindEdgeUsers(std::span<const Polyline> lines) {
  EdgeUsers users;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    for (std::size_t i = 1; i < lines[k].size(); ++i) {
      std::vector<std::size_t>& on_edge = users[Undirected(lines[k][i - 1], lines[k][i])];
      if (on_edge.empty() || on_edge.back() != k) on_edge.push_back(k);
    }
  }
  return users;
}

/// How far line `k` runs to the left of the edge's canonical direction.
double LaneOffset(const std::vector<std::size_t>& users, std::size_t k, double spacing) {
  const double count = static_cast<double>(users.size());
  const double rank = static_cast<double>(std::find(users.begin(), users.end(), k) - users.begin());
  return (rank - 0.5 * (count - 1)) * std::min(spacing, kLargestBundle / count);
}

struct Segment {
  Point a;
  Point b;
};

Segment Shifted(Point a, Point b, double left_of_canonical) {
  const double length = Distance(a, b);
  if (length == 0) return {a, b};
  const double left = a < b ? left_of_canonical : -left_of_canonical;
  const Point shift = left / length * Point{a.y - b.y, b.x - a.x};
  return {a + shift, b + shift};
}

/// Joins two shifted segments that met in `corner`: where their lines cross when that is near, else
/// by a bevel.
void AppendJoint(Polyline& line, const Segment& before, const Segment& after, Point corner) {
  constexpr double kFarthestMitre = 12;
  const Point u = before.b - before.a, v = after.b - after.a;
  const double cross = Cross(u, v);
  if (std::fabs(cross) > 1e-3 * Norm(u) * Norm(v)) {
    const Point mitre = before.a + Cross(after.a - before.a, v) / cross * u;
    if (Distance(mitre, corner) < kFarthestMitre) return line.push_back(mitre);
  }
  line.push_back(before.b);
  line.push_back(after.a);
}

}  // namespace

void DrawCurve(SvgWriter& svg, std::span<const Point> line, const LineStyle& style) {
  if (line.size() < 2 || !(Length(line) > 0)) return;
  if (style.wavy && Length(line) < kLongestWave) {
    svg.Smooth(Wave(line), {.stroke = style.colour, .width = style.width, .dashes = style.dashes});
    return;
  }
  const double edge = style.casing.empty() ? 0 : 0.9;
  if (edge > 0) svg.Polyline(line, {.stroke = style.casing, .width = style.width});
  svg.Polyline(line, {.stroke = style.colour, .width = style.width - 2 * edge, .dashes = style.dashes});
  if (style.arrows) DrawArrows(svg, line, style);
}

CurvePosition PositionAlong(std::span<const Point> line, double distance) {
  if (line.empty()) return {};
  CurvePosition position{line.front(), {1, 0}};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double length = Distance(line[i - 1], line[i]);
    if (length == 0) continue;
    position = {Lerp(line[i - 1], line[i], std::clamp(distance / length, 0.0, 1.0)),
                1 / length * (line[i] - line[i - 1])};
    if (distance <= length) break;
    distance -= length;
  }
  return position;
}

Polyline PartOf(std::span<const Point> line, double begin, double end) {
  Polyline part = {PositionAlong(line, begin).at};
  double at = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    at += Distance(line[i - 1], line[i]);
    if (at > begin && at < end) part.push_back(line[i]);
  }
  part.push_back(PositionAlong(line, end).at);
  return part;
}

std::vector<Polyline> RunSideBySide(std::span<const Polyline> lines, double spacing) {
  const EdgeUsers users = FindEdgeUsers(lines);
  std::vector<Polyline> moved;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const Polyline& line = lines[k];
    Polyline& result = moved.emplace_back();
    Segment before;
    for (std::size_t i = 1; i < line.size(); ++i) {
      const double offset = LaneOffset(users.at(Undirected(line[i - 1], line[i])), k, spacing);
      const Segment segment = Shifted(line[i - 1], line[i], offset);
      if (i == 1) {
        result.push_back(segment.a);
      } else {
        AppendJoint(result, before, segment, line[i - 1]);
      }
      before = segment;
    }
    if (line.size() > 1) result.push_back(before.b);
  }
  return moved;
}

}  // namespace tautline
