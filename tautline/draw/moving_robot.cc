#include "tautline/draw/moving_robot.h"

#include <algorithm>
#include <vector>

#include "tautline/draw/aligned_keyframes.h"

namespace tautline {
namespace {

constexpr double kShortestFilm = 6, kLongestFilm = 40, kHold = 2;  // Seconds of the viewer's time.
constexpr double kSpeedUp = 4;                                     // Of the film, where it is not too long for that.
constexpr std::size_t kMostFilmFrames = 240;

/// Evenly many of the frames, the first and the last among them.
std::vector<const DriveFrame*> FilmFrames(std::span<const DriveFrame> all) {
  const std::size_t count = all.size(), kept = std::min(count, kMostFilmFrames);
  std::vector<const DriveFrame*> frames;
  for (std::size_t i = 0; i < kept; ++i) {
    frames.push_back(&all[kept == 1 ? 0 : i * (count - 1) / (kept - 1)]);
  }
  return frames;
}

}  // namespace

void DrawMovingRobot(Figure& figure, std::span<const DriveFrame> frames, double robot_radius_m) {
  const std::vector<const DriveFrame*> film_frames = FilmFrames(frames);
  const double end = film_frames.back()->t_s;
  const double film = std::clamp(end / kSpeedUp, kShortestFilm, kLongestFilm);
  SvgMotion motion{.times = {}, .duration_s = film + kHold};
  std::vector<Polyline> cables;
  std::vector<Point> robots;
  for (const DriveFrame* frame : film_frames) {
    motion.times.push_back(end > 0 ? (frame->t_s - film_frames.front()->t_s) / end * film / motion.duration_s : 0);
    cables.push_back(figure.view().ToPixels(frame->cable));
    robots.push_back(figure.view().ToPixels(frame->robot));
  }
  motion.times.push_back(1);
  cables = AlignedKeyframes(cables);
  cables.push_back(cables.back());
  robots.push_back(robots.back());
  SvgWriter& svg = figure.map().svg();
  svg.OpenGroup("moving-cable");
  svg.MovingPolyline(cables, motion, {.stroke = kLaidCableLine.colour, .width = kLaidCableLine.width});
  svg.CloseGroup();
  svg.OpenGroup("moving-robot");
  svg.MovingCircle(robots, std::max(3.0, robot_radius_m * figure.view().pixels_per_metre()), motion,
                   {.fill = kRobotColour, .stroke = kHaloColour, .width = 1.2, .opacity = 0.6});
  svg.CloseGroup();
}

}  // namespace tautline
