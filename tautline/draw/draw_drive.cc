#include "tautline/draw/draw_drive.h"

#include <algorithm>

#include "tautline/draw/aligned_keyframes.h"
#include "tautline/draw/figure.h"
#include "tautline/draw/length_text.h"
#include "tautline/draw/moving_robot.h"

namespace tautline {
namespace {

const LineStyle kDriveLine = {.colour = "#0b4a8f", .width = 1.4};

std::size_t CountContacts(const DrivePicture& picture, ContactKind kind) {
  return static_cast<std::size_t>(std::count_if(picture.contacts.begin(), picture.contacts.end(),
                                                [kind](const Contact& contact) { return contact.kind == kind; }));
}

std::string TimesText(std::size_t count) { return std::to_string(count) + (count == 1 ? " time" : " times"); }

std::size_t CountVisited(const DrivePicture& picture) {
  return static_cast<std::size_t>(
      std::count_if(picture.goals.begin(), picture.goals.end(),
                    [](const GoalOutcome& goal) { return goal.failure == DriveFailure::kNone; }));
}

std::string TitleOf(const DrivePicture& picture) {
  if (picture.frames.empty()) return "No drive";
  return std::to_string(CountVisited(picture)) + " of " + std::to_string(picture.goals.size()) +
         (picture.goals.size() == 1 ? " goal" : " goals") + " visited in " + FixedText(picture.frames.back().t_s, 1) +
         " s";
}

FigureContent ContentOf(const DrivePicture& picture, bool film) {
  FigureContent content{.title = TitleOf(picture)};
  if (!picture.explanation.empty()) content.notes.push_back(picture.explanation);
  if (picture.frames.empty()) return content;
  content.legend = {
      {kDriveLine, "the robot's way"},
      {kLaidCableLine, film ? "the cable" : "the cable in the end"},
      {Marker::kRing, "the robot drove over its cable " + TimesText(CountContacts(picture, ContactKind::kRobot))},
      {Marker::kCrossing, "an obstacle caught the cable " + TimesText(CountContacts(picture, ContactKind::kObstacle))}};
  if (CountVisited(picture) < picture.goals.size()) content.legend.push_back({Marker::kBlocked, "goal not visited"});
  return content;
}

void DrawStill(Figure& figure, const Scene& scene, const DrivePicture& picture) {
  Polyline way;
  for (const DriveFrame& frame : picture.frames) way.push_back(frame.robot);
  if (way.size() > 1) figure.Line("way", way, kDriveLine);
  for (const Contact& contact : picture.contacts) {
    figure.Mark(contact.kind == ContactKind::kRobot ? Marker::kRing : Marker::kCrossing, contact.at);
  }
  figure.Mark(Marker::kBase, scene.tether->base, "base");
  for (std::size_t i = 0; i < picture.goals.size(); ++i) {
    const bool visited = picture.goals[i].failure == DriveFailure::kNone;
    figure.Mark(visited ? Marker::kGoal : Marker::kBlocked, picture.goals[i].goal, std::to_string(i + 1));
  }
}

SvgCurve CircleAt(Point centre, double radius) {
  const Point side{radius, 0};
  return {.start = centre - side,
          .steps = {{.to = centre + side, .radius = radius * (1 + 1e-9)},
                    {.to = centre - side, .radius = radius * (1 + 1e-9)}},
          .closed = true};
}

}  // namespace

std::string DrawDrive(const Scene& scene, const DrivePicture& picture) {
  const auto space = BuildFreeSpace(scene.world);
  if (!space) return "";
  Figure figure(scene, *space, ContentOf(picture, false));
  if (!picture.frames.empty()) {
    figure.Line("cable", picture.frames.back().cable, kLaidCableLine);
    const double radius = picture.robot_radius_m * figure.view().pixels_per_metre();
    if (radius > 0) {
      figure.Shape("robot", std::vector{CircleAt(figure.view().ToPixels(picture.frames.back().robot), radius)},
                   {.fill = kRobotColour, .opacity = 0.4});
    }
  }
  DrawStill(figure, scene, picture);
  return figure.Finish();
}

std::string AnimateDrive(const Scene& scene, const DrivePicture& picture) {
  const auto space = BuildFreeSpace(scene.world);
  if (!space) return "";
  Figure figure(scene, *space, ContentOf(picture, true));
  DrawStill(figure, scene, picture);
  if (!picture.frames.empty()) DrawMovingRobot(figure, picture.frames, picture.robot_radius_m);
  return figure.Finish();
}

}  // namespace tautline
