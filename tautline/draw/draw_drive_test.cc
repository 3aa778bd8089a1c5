// The pictures of drives.
#include "tautline/draw/draw_drive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tautline/draw/draw_untangling.h"
#include "tautline/draw/xml_check.h"
#include "tautline/planners/grid_manifold/sketched_hall.h"

namespace tautline {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

std::size_t CountOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// A hall whose fourth goal needs an untangling.
struct Example {
  Hall hall = Hall({{{1.75, 1.75}, 0.15}, {{3.3, 1.2}, 0.15}}, 5.5);
  std::vector<Point> goals = {{2.65, 0.55}, {1.05, 2.55}, {1.05, 0.45}, {2.65, 2.45}};
  DriveOptions options;
  DriveState start = hall.Start();
  DriveResult result = Drive(*hall.manifold, start, goals, options);

  DrivePicture Picture() const {
    const auto contacts = result.end.cable.contacts();
    return {.frames = TraceDrive(*hall.manifold, start, result, options.robot, {.sample_s = 0.5}),
            .contacts = {contacts.begin(), contacts.end()},
            .goals = result.goals,
            .robot_radius_m = 0.17,
            .explanation = ""};
  }
};

TEST(DrawDrive, ShowsWayCableAndContacts) {
  const Example e;
  DrivePicture picture = e.Picture();
  picture.contacts.push_back({.kind = ContactKind::kRobot, .time_s = 1, .at = {2, 0.5}, .corner = {}});
  const std::string svg = DrawDrive(e.hall.scene, picture);
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(XmlCheck(svg).classes(), IsSupersetOf({"way", "cable", "robot", "markers"}));
  EXPECT_THAT(svg, AllOf(HasSubstr("4 of 4 goals visited"), HasSubstr("over its cable 1 time"), Not(HasSubstr("nan"))));
  EXPECT_EQ(svg, DrawDrive(e.hall.scene, picture));
}

TEST(DrawDrive, ExplainsTheSignOfGoalsThatWereNotVisited) {
  const Example e;
  DrivePicture picture = e.Picture();
  EXPECT_THAT(DrawDrive(e.hall.scene, picture), Not(HasSubstr("goal not visited")));
  picture.goals[3].failure = DriveFailure::kWayNotFound;
  EXPECT_THAT(DrawDrive(e.hall.scene, picture), AllOf(HasSubstr("3 of 4 goals"), HasSubstr("goal not visited")));
}

TEST(DrawDrive, SaysWhyThereIsNone) {
  const Example e;
  const DrivePicture picture{.frames = {}, .contacts = {}, .goals = {}, .explanation = "The base is blocked."};
  for (const std::string& svg : {DrawDrive(e.hall.scene, picture), AnimateDrive(e.hall.scene, picture)}) {
    EXPECT_EQ(XmlCheck(svg).error(), "");
    EXPECT_THAT(svg, AllOf(HasSubstr("No drive"), HasSubstr("The base is blocked."), Not(HasSubstr("<animate"))));
  }
}

TEST(AnimateDrive, MovesRobotAndCable) {
  const Example e;
  const std::string svg = AnimateDrive(e.hall.scene, e.Picture());
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(XmlCheck(svg).classes(), IsSupersetOf({"moving-cable", "moving-robot"}));
  EXPECT_GE(CountOf(svg, "<animate"), 2U);
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(DrawUntangling, ShowsCandidatesWithTheirScores) {
  const Example e;
  const DriveState before =
      Replay(*e.hall.manifold, e.start, std::span(e.result.end.way).first(e.result.goals[2].steps), e.options.robot);
  EXPECT_EQ(before.cable.time_s(), e.result.goals[2].time_s);
  const TargetTrials trials = TryTargets(*e.hall.manifold, before, e.goals[3], e.options);
  EXPECT_FALSE(trials.open);
  ASSERT_TRUE(trials.chosen);
  EXPECT_TRUE(trials.targets[*trials.chosen].clears) << "as the drive found";
  for (std::size_t i = 0; i < *trials.chosen; ++i) EXPECT_FALSE(trials.targets[i].clears) << "the first one";
  const std::string svg = DrawUntangling(e.hall.scene, e.hall.ground().grid(), trials);
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(XmlCheck(svg).classes(), IsSupersetOf({"region", "trials", "after", "chosen", "cable", "markers"}));
  EXPECT_THAT(svg, AllOf(HasSubstr("Driving to 1 clears the way"), HasSubstr("1: 1.05 m"), Not(HasSubstr("nan"))));
}

TEST(DrawUntangling, NumbersTheFirstDozen) {
  const Example e;
  TargetTrials trials = TryTargets(*e.hall.manifold, e.start, e.goals[0], e.options);
  ASSERT_FALSE(trials.targets.empty());
  trials.targets.resize(1);
  trials.targets.resize(20, trials.targets[0]);
  trials.chosen = 14;
  const std::string svg = DrawUntangling(e.hall.scene, e.hall.ground().grid(), trials);
  EXPECT_THAT(svg, AllOf(HasSubstr("Of the other 8"), HasSubstr(">12: "), HasSubstr(">15: "), Not(HasSubstr(">13: "))));
}

}  // namespace
}  // namespace tautline
