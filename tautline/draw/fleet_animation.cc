// The film of a fleet.
#include <algorithm>

#include "tautline/base/check.h"
#include "tautline/draw/aligned_keyframes.h"
#include "tautline/draw/draw_fleet.h"
#include "tautline/draw/figure.h"
#include "tautline/draw/fleet_layers.h"
#include "tautline/draw/fleet_schedule.h"
#include "tautline/draw/length_text.h"
#include "tautline/draw/sheet.h"

namespace tautline {
namespace {

constexpr double kPadding = 26;
constexpr double kTallestMap = 620;
constexpr double kLowestMap = 160;
constexpr double kShortestFilm = 6;  // Seconds of the viewer's time.
constexpr double kLongestFilm = 24;
constexpr double kHold = 2;  // The end stands still for so long, seconds.
constexpr double kRobotRadius = 6;
constexpr std::size_t kMostWithClock = 200;  // Keyframes.

/// The times of keyframes in the viewer's round, with the end held.
SvgMotion MotionOf(const std::vector<PlaybackFrame>& frames) {
  const double end = frames.back().t;
  const double film = std::clamp(end, kShortestFilm, kLongestFilm);
  SvgMotion motion{.times = {}, .duration_s = film + kHold};
  for (const PlaybackFrame& frame : frames) {
    motion.times.push_back(end > 0 ? frame.t / end * film / motion.duration_s : 0);
  }
  motion.times.front() = 0;
  motion.times.push_back(1);
  return motion;
}

/// One robot's cable and place in each keyframe, in pixels; the last twice, since it is held.
struct Track {
  std::vector<Polyline> cable;
  std::vector<Point> robot;
};

Track TrackOf(const View& view, const std::vector<PlaybackFrame>& frames, std::size_t robot) {
  Track track;
  for (const PlaybackFrame& frame : frames) {
    track.cable.push_back(view.ToPixels(frame.cables[robot]));
    track.robot.push_back(view.ToPixels(frame.robots[robot]));
  }
  track.cable = AlignedKeyframes(track.cable);
  track.cable.push_back(track.cable.back());
  track.robot.push_back(track.robot.back());
  return track;
}

/// "3 robots, straight-concurrent: 14 s".
std::string PlanText(const FleetGround& ground, const FleetPlan& plan) {
  return std::to_string(ground.size()) + (ground.size() == 1 ? " robot, " : " robots, ") + ToString(plan.mode) + ": " +
         TimeText(plan.travel_time);
}

void DrawStill(MapDrawing& map, const FleetGround& ground, const FleetFilm& film) {
  if (ground.size() > kMostInGraphs) return;
  for (const Route& route : film.layout) {
    map.Line("wanted", PointsOf(ground, route), {.colour = "#d9dce0", .width = 4});
  }
  for (const RobotSchedule& schedule : film.plan.schedule) {
    map.Line("path", schedule.path.points, {.colour = "#9a9a9a", .width = 0.8, .dashes = "2 4"});
  }
}

void DrawMoving(SvgWriter& svg, const View& view, const FleetGround& ground, const FleetFilm& film) {
  const SvgMotion motion = MotionOf(film.frames);
  const std::size_t count = ground.size();
  std::vector<Track> tracks;
  for (std::size_t i = 0; i < count; ++i) tracks.push_back(TrackOf(view, film.frames, i));
  svg.OpenGroup("moving-cables");
  for (std::size_t i = 0; i < count; ++i) {
    const LineStyle line = RobotLine(RobotId(i), count);
    svg.MovingPolyline(tracks[i].cable, motion, {.stroke = line.colour, .width = line.width, .dashes = line.dashes});
  }
  svg.CloseGroup();
  svg.OpenGroup("moving-robots");
  for (std::size_t i = 0; i < count; ++i) {
    svg.MovingCircle(tracks[i].robot, count <= 30 ? kRobotRadius : 2.5, motion,
                     {.fill = RobotLine(RobotId(i), count).colour, .stroke = kHaloColour, .width = 1.2});
  }
  svg.CloseGroup();
}

/// A line that runs over the schedule, and the time.
void DrawClock(SvgWriter& svg, const GanttChart& chart, const Box& frame, const FleetFilm& film) {
  const SvgMotion motion = MotionOf(film.frames);
  std::vector<Polyline> lines;
  std::vector<std::string> times;
  for (const PlaybackFrame& frame_of : film.frames) {
    lines.push_back(chart.LineAt(frame_of.t));
    times.push_back(FixedText(frame_of.t, film.frames.back().t < 1000 ? 1 : 0) + " s");
  }
  lines.push_back(lines.back());
  times.push_back(times.back());
  svg.OpenGroup("clock");
  svg.MovingPolyline(lines, motion, {.stroke = kWarningColour, .width = 1.6});
  if (times.size() <= kMostWithClock) {
    svg.TextInTurns(
        {.at = {frame.high.x - 12, frame.low.y - 8}, .text = "", .size = 14, .anchor = TextAnchor::kEnd, .bold = true},
        times, motion);
  }
  svg.CloseGroup();
}

}  // namespace

int FilmFrames(std::size_t robots) { return robots <= 30 ? 160 : robots <= 300 ? 60 : 25; }

std::string AnimateFleet(const Scene& scene, const FleetGround& ground, const FleetFilm& film) {
  TAUTLINE_CHECK(!film.frames.empty());
  const FreeSpace space = DrawnSpace(ground);
  const Box box = FleetBox(ground);
  const double width = SheetFrameWidth(1, 1, 1);
  const double height =
      std::clamp((width - 2 * kPadding) / box.size().x * box.size().y + 2 * kPadding, kLowestMap, kTallestMap);
  SheetContent sheet{
      .title = film.title.empty() ? PlanText(ground, film.plan) : film.title, .rows = {}, .legend = MarksLegend()};
  const auto map_panel = [&](SvgWriter& svg, const Box& frame) {
    const Point padding{kPadding, kPadding};
    const View view(box, {frame.low + padding, frame.high - padding});
    MapDrawing map(svg, {.world = scene.world, .space = space, .view = view, .options = {.frame = frame}});
    DrawStill(map, ground, film);
    MarkFleet(map, ground);
    map.Finish();
    svg.OpenWindow("film", frame);
    DrawMoving(svg, view, ground, film);
    svg.CloseWindow();
  };
  sheet.rows.push_back({.panels = {{.title = "Motion", .notes = {}, .draw = map_panel}}, .height = height});
  std::vector<GanttRow> rows = ScheduleRows(ground, film.plan);
  const auto schedule_panel = [&](SvgWriter& svg, const Box& frame) {
    const GanttChart chart(frame, rows, film.plan.travel_time);
    chart.Draw(svg);
    DrawClock(svg, chart, frame, film);
  };
  sheet.rows.push_back({.panels = {{.title = "Schedule", .notes = {}, .draw = schedule_panel}},
                        .height = GanttChart::HeightOf(rows.size())});
  return DrawSheet(sheet);
}

}  // namespace tautline
