#include "tautline/draw/fleet_layers.h"

#include <algorithm>

#include "tautline/draw/length_text.h"
#include "tautline/planners/fleet/tracks.h"

namespace tautline {
namespace {

constexpr int kMostLooks = 12;                // Of robots side by side in colour; more would look alike.
constexpr std::size_t kMostNamedStarts = 30;  // With more robots, only targets are named.
constexpr std::size_t kMostNamedTargets = 80;
constexpr std::size_t kMostMarked = 200;  // With more robots, starts and targets are small dots.
constexpr double kTrackSpacing = 4;       // Pixels between lines that share an edge.

}  // namespace

LineStyle RobotLine(RobotId robot, std::size_t count) {
  const int looks = static_cast<int>(std::clamp<std::size_t>(count, 1, kMostLooks));
  LineStyle style = ClassLine(static_cast<int>(robot.index() % static_cast<std::size_t>(looks)), looks);
  style.width = count <= kMostNamedStarts ? 2 : count <= kMostMarked ? 1.2 : 0.6;
  if (count > kMostMarked) style.dashes.clear();
  return style;
}

FreeSpace DrawnSpace(const FleetGround& ground) {
  return ground.space() == nullptr ? FreeSpace{} : ground.space()->free_space();
}

std::vector<Point> FleetPoints(const FleetGround& ground) {
  std::vector<Point> points;
  for (const FleetRobot& robot : ground.robots()) {
    points.push_back(robot.start);
    points.push_back(robot.target);
    if (robot.cable) points.insert(points.end(), robot.cable->begin(), robot.cable->end());
  }
  return points;
}

Box FleetBox(const FleetGround& ground) {
  const Box box = ground.space() == nullptr ? BoundingBox(FleetPoints(ground)) : ground.space()->free_space().box;
  return WithoutFlatSides(box);
}

int FleetDecimals(const FleetGround& ground) {
  const Point size = FleetBox(ground).size();
  return LengthDecimals(std::max(size.x, size.y));
}

std::vector<Polyline> CableTracks(const View& view, const FleetGround& ground, const FleetLayout& layout) {
  std::vector<Polyline> lines = SideBySide(ground, layout, {.spacing = kTrackSpacing / view.pixels_per_metre()});
  for (Polyline& line : lines) line = view.ToPixels(line);
  return lines;
}

void DrawCableLines(MapDrawing& map, const FleetGround& ground, const FleetLayout& layout) {
  const std::vector<Polyline> tracks = CableTracks(map.view(), ground, layout);
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    map.PixelLine("cable-line", tracks[i], RobotLine(RobotId(i), ground.size()));
  }
}

void MarkFleet(MapDrawing& map, const FleetGround& ground) {
  const std::size_t count = ground.size();
  for (std::size_t i = 0; i < count; ++i) {
    const FleetRobot& robot = ground.robots()[i];
    const std::string colour = RobotLine(RobotId(i), count).colour;
    if (count > kMostMarked) {
      const Point at = map.view().ToPixels(robot.start);
      map.svg().Rectangle({at - Point{1.6, 1.6}, at + Point{1.6, 1.6}}, {.fill = colour});
      map.svg().Circle(map.view().ToPixels(robot.target), 1.8, {.fill = colour});
      continue;
    }
    map.Mark(Marker::kStart, robot.start, count <= kMostNamedStarts ? robot.name : "", colour);
    map.Mark(Marker::kTarget, robot.target, count <= kMostNamedTargets ? robot.name : "", colour);
  }
}

std::vector<LegendEntry> MarksLegend() {
  return {{Marker::kStart, "start of a robot: its cable is tied here"}, {Marker::kTarget, "target of a robot"}};
}

std::string NamesText(const FleetGround& ground, std::span<const RobotId> robots) {
  constexpr std::size_t kMost = 6;
  const std::size_t named = robots.size() <= kMost ? robots.size() : kMost - 1;
  std::string text;
  for (std::size_t i = 0; i < named; ++i) {
    const bool last = i + 1 == robots.size();
    text += (i == 0 ? "" : last ? " and " : ", ") + ground.robot(robots[i]).name;
  }
  return named == robots.size() ? text : text + " and " + std::to_string(robots.size() - named) + " more";
}

std::string TimeText(double seconds) { return CompactText(seconds, seconds < 10 ? 3 : seconds < 1000 ? 2 : 0) + " s"; }

}  // namespace tautline
