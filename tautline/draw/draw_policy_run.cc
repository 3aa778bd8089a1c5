#include "tautline/draw/draw_policy_run.h"

#include <cmath>

#include "tautline/draw/figure.h"
#include "tautline/draw/length_text.h"
#include "tautline/draw/moving_robot.h"

namespace tautline {
namespace {

const LineStyle kDrivenLine = {.colour = kRobotColour, .width = 2.2, .arrows = true};
const LineStyle kReferenceLine = {.colour = "#00684c", .width = 1.6, .dashes = "7 4"};
const LineStyle kEarlierCableLine = {.colour = "#b98a2c", .width = 1.3};
const LineStyle kHeadingLine = {.colour = kRobotColour, .width = 1.6};
/// Moments at which robot and cable are drawn, besides the end.
constexpr std::size_t kSnapshots = 4;

/// Indices of frames evenly along the path, the first and the last among them.
std::vector<std::size_t> Snapshots(const std::vector<EnvFrame>& frames) {
  std::vector<double> along{0};
  for (std::size_t i = 1; i < frames.size(); ++i) {
    along.push_back(along.back() + Distance(frames[i - 1].pose.at, frames[i].pose.at));
  }
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k <= kSnapshots; ++k) {
    const double at = along.back() * static_cast<double>(k) / kSnapshots;
    std::size_t i = chosen.empty() ? 0 : chosen.back();
    while (i + 1 < frames.size() && along[i] < at) ++i;
    if (chosen.empty() || i != chosen.back()) chosen.push_back(i);
  }
  chosen.back() = frames.size() - 1;
  return chosen;
}

struct ContactCounts {
  std::size_t robot = 0, obstacle = 0;
};

/// Visits the frames at which a contact begins.
template <class Visit>
ContactCounts ForEachContact(const std::vector<EnvFrame>& frames, const Visit& visit) {
  ContactCounts counts;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    if (frames[i].cable_robot && !frames[i - 1].cable_robot) {
      visit(frames[i], Marker::kRing);
      ++counts.robot;
    }
    if (frames[i].cable_obstacle && !frames[i - 1].cable_obstacle) {
      visit(frames[i], Marker::kCrossing);
      ++counts.obstacle;
    }
  }
  return counts;
}

std::string TimesText(std::size_t count) { return std::to_string(count) + (count == 1 ? " time" : " times"); }

FigureContent ContentOf(const PolicyRunPicture& picture, int decimals, bool film) {
  FigureContent content{.title = "No drive"};
  if (!picture.explanation.empty()) content.notes.push_back(picture.explanation);
  if (picture.frames.empty()) return content;
  content.title = std::string(picture.success ? "Goal reached" : "Goal not reached") + " in " +
                  FixedText(picture.frames.back().t_s, 1) + " s and " + LengthText(picture.length_m, decimals);
  const ContactCounts counts = ForEachContact(picture.frames, [](const EnvFrame&, Marker) {});
  content.legend = {{kDrivenLine, "the robot's path"},
                    {kReferenceLine, "the reference path"},
                    {kLaidCableLine, film ? "the cable" : "the cable in the end"},
                    {Marker::kRing, "here the robot came upon its cable, " + TimesText(counts.robot)},
                    {Marker::kCrossing, "here the cable came upon an obstacle, " + TimesText(counts.obstacle)}};
  if (!film) content.legend.insert(content.legend.begin() + 3, {kEarlierCableLine, "the cable at earlier moments"});
  return content;
}

SvgCurve CircleAt(Point centre, double radius) {
  const Point side{radius, 0};
  return {.start = centre - side,
          .steps = {{.to = centre + side, .radius = radius * (1 + 1e-9)},
                    {.to = centre - side, .radius = radius * (1 + 1e-9)}},
          .closed = true};
}

void DrawSnapshots(Figure& figure, const PolicyRunPicture& picture) {
  const auto chosen = Snapshots(picture.frames);
  const double radius = picture.robot_radius_m * figure.view().pixels_per_metre();
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    const EnvFrame& frame = picture.frames[chosen[k]];
    const bool last = k + 1 == chosen.size();
    figure.Line(last ? "cable" : "earlier-cable", frame.cable, last ? kLaidCableLine : kEarlierCableLine);
    figure.Shape("robot", std::vector{CircleAt(figure.view().ToPixels(frame.pose.at), radius)},
                 {.fill = kRobotColour, .stroke = kRobotColour, .width = 1, .opacity = last ? 0.4 : 0.12});
    const Point nose =
        picture.robot_radius_m * Point{std::cos(frame.pose.heading_rad), std::sin(frame.pose.heading_rad)};
    figure.Line("heading", Polyline{frame.pose.at, frame.pose.at + nose}, kHeadingLine);
  }
}

void DrawWay(Figure& figure, const Scene& scene, const PolicyRunPicture& picture) {
  if (picture.reference.size() > 1) figure.Line("reference", picture.reference, kReferenceLine);
  Polyline path;
  for (const EnvFrame& frame : picture.frames) {
    if (path.empty() || path.back() != frame.pose.at) path.push_back(frame.pose.at);
  }
  if (path.size() > 1) figure.Line("path", path, kDrivenLine);
  ForEachContact(picture.frames, [&](const EnvFrame& frame, Marker marker) { figure.Mark(marker, frame.pose.at); });
  figure.Mark(Marker::kBase, scene.tether->base, "base");
  if (scene.goal) figure.Mark(Marker::kGoal, *scene.goal, "goal");
}

}  // namespace

std::string DrawPolicyRun(const Scene& scene, const PolicyRunPicture& picture) {
  const auto space = BuildFreeSpace(scene.world);
  if (!space) return "";
  Figure figure(scene, *space, ContentOf(picture, LengthDecimals(*space), false));
  if (!picture.frames.empty()) DrawSnapshots(figure, picture);
  DrawWay(figure, scene, picture);
  return figure.Finish();
}

std::string AnimatePolicyRun(const Scene& scene, const PolicyRunPicture& picture) {
  const auto space = BuildFreeSpace(scene.world);
  if (!space) return "";
  Figure figure(scene, *space, ContentOf(picture, LengthDecimals(*space), true));
  DrawWay(figure, scene, picture);
  if (!picture.frames.empty()) {
    std::vector<DriveFrame> frames;
    for (const EnvFrame& frame : picture.frames) {
      frames.push_back({.t_s = frame.t_s, .robot = frame.pose.at, .cable = frame.cable});
    }
    DrawMovingRobot(figure, frames, picture.robot_radius_m);
  }
  return figure.Finish();
}

}  // namespace tautline
