#include "tautline/draw/draw_contact_free.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tautline/draw/aligned_keyframes.h"
#include "tautline/draw/figure.h"
#include "tautline/draw/length_text.h"

namespace tautline {
namespace {

const LineStyle kWayLine = {.colour = "#0b4a8f", .width = 1.8};
const LineStyle kEndCableLine = {.colour = "#8f6400", .width = 2.6};
const LineStyle kPassingCableLine = {.colour = "#c9ab6b", .width = 1};
const LineStyle kLaidCableLine = {.colour = "#333333", .width = 1.6, .dashes = "5 3"};
constexpr char kRobotColour[] = "#0b4a8f";
constexpr double kSnapshotEvery = 3;                                             // Seconds.
constexpr double kShortestFilm = 5, kLongestFilm = 30, kHold = 2, kSpeedUp = 2;  // Of the viewer's time; times.
constexpr std::size_t kMostFilmFrames = 240;

/// The cable up to the robot's tail and on to its centre.
Polyline CableAt(const DrivenMotion& motion, std::size_t step) { return motion.cables[step]; }

/// The steps at which a contact of a kind begins.
template <class Touches>
std::vector<std::size_t> Beginnings(const DrivenMotion& motion, Touches touches) {
  std::vector<std::size_t> steps;
  for (std::size_t i = 0; i < motion.outcomes.size(); ++i) {
    if (touches(motion.outcomes[i]) && (i == 0 || !touches(motion.outcomes[i - 1]))) steps.push_back(i + 1);
  }
  return steps;
}

bool TouchesObstacle(const EnvStep& step) { return step.cable_obstacle; }
bool TouchesRobot(const EnvStep& step) { return step.cable_robot; }

std::string StepsText(int steps) { return std::to_string(steps) + (steps == 1 ? " step" : " steps"); }

FigureContent ContentOf(const ContactFreePicture& picture, bool film) {
  const MotionCosts& costs = picture.motion.costs;
  if (picture.motion.poses.empty()) {
    FigureContent none{.title = "No motion"};
    if (!picture.explanation.empty()) none.notes.push_back(picture.explanation);
    return none;
  }
  const auto& outcomes = picture.motion.outcomes;
  const auto contacts = static_cast<int>(std::count_if(outcomes.begin(), outcomes.end(), [](const EnvStep& step) {
    return TouchesObstacle(step) || TouchesRobot(step);  // Once, where it does both.
  }));
  FigureContent content{.title = FixedText(costs.length_m, 1) + " m in " + FixedText(picture.dt_s * costs.steps, 1) +
                                 " s, " + (contacts == 0 ? "nothing touches" : StepsText(contacts) + " with contact")};
  content.legend = {{kWayLine, "the robot's way"}};
  if (film) {
    content.legend.push_back({kEndCableLine, "the cable"});
  } else {
    content.legend.push_back({kLaidCableLine, "the cable at the start"});
    content.legend.push_back({kPassingCableLine, "every " + FixedText(kSnapshotEvery, 0) + " s"});
    content.legend.push_back({kEndCableLine, "at the end"});
  }
  if (costs.cable_robot_steps > 0) {
    content.legend.push_back(
        {Marker::kRing, "the robot drives onto its cable: " + StepsText(costs.cable_robot_steps) + " in all"});
  }
  if (costs.cable_obstacle_steps > 0) {
    content.legend.push_back({Marker::kCrossing, "where the robot is when the cable begins to touch: " +
                                                     StepsText(costs.cable_obstacle_steps) + " in all"});
  }
  return content;
}

SvgCurve CircleAt(Point centre, double radius) {
  const Point side{radius, 0};
  return {.start = centre - side,
          .steps = {{.to = centre + side, .radius = radius * (1 + 1e-9)},
                    {.to = centre - side, .radius = radius * (1 + 1e-9)}},
          .closed = true};
}

/// The disc, and a stroke from its centre ahead.
void DrawRobot(Figure& figure, const ContactFreePicture& picture, const RobotPose& pose, double opacity) {
  const Point centre = figure.view().ToPixels(pose.at);
  const double radius = picture.robot_radius_m * figure.view().pixels_per_metre();
  figure.Shape("robot", std::vector{CircleAt(centre, radius)}, {.fill = kRobotColour, .opacity = opacity});
  const Point ahead = pose.at + picture.robot_radius_m * Point{std::cos(pose.heading_rad), std::sin(pose.heading_rad)};
  figure.Line("heading", std::vector{pose.at, ahead}, {.colour = kRobotColour, .width = 1.2});
}

void DrawSnapshots(Figure& figure, const ContactFreePicture& picture) {
  const DrivenMotion& motion = picture.motion;
  const auto every = static_cast<std::size_t>(std::max(1.0, std::round(kSnapshotEvery / picture.dt_s)));
  for (std::size_t i = every; i + every / 2 < motion.poses.size(); i += every) {
    figure.Line("passing-cable", CableAt(motion, i), kPassingCableLine);
    DrawRobot(figure, picture, motion.poses[i], 0.12);
  }
  figure.Line("start-cable", CableAt(motion, 0), kLaidCableLine);
  figure.Line("end-cable", CableAt(motion, motion.cables.size() - 1), kEndCableLine);
  DrawRobot(figure, picture, motion.poses.front(), 0.2);
  DrawRobot(figure, picture, motion.poses.back(), 0.4);
}

void DrawWay(Figure& figure, const Scene& scene, const ContactFreePicture& picture) {
  const DrivenMotion& motion = picture.motion;
  const Polyline way = motion.Path();
  if (way.size() > 1) figure.Line("way", way, kWayLine);
  for (const std::size_t step : Beginnings(motion, TouchesObstacle)) {
    figure.Mark(Marker::kCrossing, motion.poses[step].at);
  }
  for (const std::size_t step : Beginnings(motion, TouchesRobot)) figure.Mark(Marker::kRing, motion.poses[step].at);
  figure.Mark(Marker::kBase, scene.tether->base, "base");
  figure.Mark(motion.poses.empty() ? Marker::kBlocked : Marker::kGoal, *scene.goal, "goal");
}

/// Evenly many of the steps, the first and the last among them.
std::vector<std::size_t> FilmSteps(const DrivenMotion& motion) {
  const std::size_t count = motion.poses.size(), kept = std::min(count, kMostFilmFrames);
  std::vector<std::size_t> steps;
  for (std::size_t i = 0; i < kept; ++i) steps.push_back(kept == 1 ? 0 : i * (count - 1) / (kept - 1));
  return steps;
}

void DrawMoving(Figure& figure, const ContactFreePicture& picture) {
  const std::vector<std::size_t> steps = FilmSteps(picture.motion);
  const auto end = static_cast<double>(std::max<std::size_t>(1, steps.back()));
  const double film = std::clamp(end * picture.dt_s / kSpeedUp, kShortestFilm, kLongestFilm);
  SvgMotion motion{.times = {}, .duration_s = film + kHold};
  std::vector<Polyline> cables, headings;
  std::vector<Point> robots;
  for (const std::size_t step : steps) {
    motion.times.push_back(static_cast<double>(step) / end * film / motion.duration_s);
    const RobotPose& pose = picture.motion.poses[step];
    const Point ahead{std::cos(pose.heading_rad), std::sin(pose.heading_rad)};
    cables.push_back(figure.view().ToPixels(CableAt(picture.motion, step)));
    robots.push_back(figure.view().ToPixels(pose.at));
    headings.push_back(figure.view().ToPixels(std::vector{pose.at, pose.at + picture.robot_radius_m * ahead}));
  }
  motion.times.push_back(1);
  cables = AlignedKeyframes(cables);
  cables.push_back(cables.back());
  robots.push_back(robots.back());
  headings.push_back(headings.back());
  SvgWriter& svg = figure.map().svg();
  svg.OpenGroup("moving-robot");
  svg.MovingCircle(robots, std::max(3.0, picture.robot_radius_m * figure.view().pixels_per_metre()), motion,
                   {.fill = kRobotColour, .stroke = kHaloColour, .width = 1.2, .opacity = 0.4});
  svg.MovingPolyline(headings, motion, {.stroke = kRobotColour, .width = 1.4});
  svg.CloseGroup();
  svg.OpenGroup("moving-cable");
  svg.MovingPolyline(cables, motion, {.stroke = kEndCableLine.colour, .width = kEndCableLine.width});
  svg.CloseGroup();
}

}  // namespace

std::string DrawContactFree(const Scene& scene, const ContactFreePicture& picture) {
  const auto space = BuildFreeSpace(scene.world);
  if (!space) return "";
  Figure figure(scene, *space, ContentOf(picture, false));
  if (!picture.motion.poses.empty()) DrawSnapshots(figure, picture);
  DrawWay(figure, scene, picture);
  return figure.Finish();
}

std::string AnimateContactFree(const Scene& scene, const ContactFreePicture& picture) {
  const auto space = BuildFreeSpace(scene.world);
  if (!space) return "";
  Figure figure(scene, *space, ContentOf(picture, true));
  DrawWay(figure, scene, picture);
  if (!picture.motion.poses.empty()) DrawMoving(figure, picture);
  return figure.Finish();
}

}  // namespace tautline
