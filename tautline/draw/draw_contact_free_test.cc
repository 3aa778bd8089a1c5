// The pictures of contact-free motions.
#include "tautline/draw/draw_contact_free.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tautline/draw/xml_check.h"

namespace tautline {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

/// A robot that drives 5 m straight on past a block; some steps count as contacts.
struct Example {
  Scene scene{.world = {.outline = {{0, 0}, {9, 0}, {9, 6}, {0, 6}}},
              .tether = Tether{.base = {1, 2}, .length = 9},
              .goal = Point{7, 2}};
  ContactFreePicture picture;

  Example() {
    for (int i = 0; i <= 50; ++i) {
      const Point at{1.5 + 0.1 * i, 2};
      picture.motion.poses.push_back({at, 0});
      picture.motion.cables.push_back({{1, 2}, at - Point{0.5, 0}});
    }
    picture.motion.outcomes.resize(50);
    picture.motion.costs.steps = 50;
    picture.motion.costs.length_m = 5;
  }
};

TEST(DrawContactFree, ShowsWayAndCables) {
  const Example e;
  const std::string svg = DrawContactFree(e.scene, e.picture);
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(XmlCheck(svg).classes(), IsSupersetOf({"way", "start-cable", "end-cable", "passing-cable", "robot"}));
  EXPECT_THAT(svg, AllOf(HasSubstr("5.0 m in 5.0 s, nothing touches"), Not(HasSubstr("nan"))));
  EXPECT_EQ(svg, DrawContactFree(e.scene, e.picture));
}

TEST(DrawContactFree, CountsContacts) {
  Example e;
  e.picture.motion.outcomes[10].cable_robot = e.picture.motion.outcomes[11].cable_robot = true;
  e.picture.motion.costs.cable_robot_steps = 2;
  e.picture.motion.outcomes[11].cable_obstacle = true;  // The same step.
  e.picture.motion.costs.cable_obstacle_steps = 1;
  EXPECT_THAT(DrawContactFree(e.scene, e.picture), AllOf(HasSubstr("2 steps with contact"), HasSubstr("its cable: 2")));
}

TEST(DrawContactFree, MovesInAFilm) {
  const Example e;
  const std::string svg = AnimateContactFree(e.scene, e.picture);
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(XmlCheck(svg).classes(), IsSupersetOf({"moving-cable", "moving-robot"}));
  EXPECT_THAT(svg, HasSubstr("<animate"));
}

TEST(DrawContactFree, SaysWhyThereIsNone) {
  Example e;
  e.picture.motion = {};
  e.picture.explanation = "no way is wide enough";
  for (const std::string& svg : {DrawContactFree(e.scene, e.picture), AnimateContactFree(e.scene, e.picture)}) {
    EXPECT_EQ(XmlCheck(svg).error(), "");
    EXPECT_THAT(svg, AllOf(HasSubstr("No motion"), HasSubstr("no way is wide enough"), Not(HasSubstr("<animate"))));
  }
}

}  // namespace
}  // namespace tautline
