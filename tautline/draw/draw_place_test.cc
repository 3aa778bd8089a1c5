#include "tautline/draw/draw_place.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tautline/draw/xml_check.h"

namespace tautline {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Scene Hall() {
  Scene scene;
  scene.world.outline = {{0, 0}, {12, 0}, {12, 8}, {0, 8}};
  scene.world.obstacles.push_back({.name = "post", .polygon = PolygonWithHoles{{{5, 3}, {6, 3}, {6, 4}, {5, 4}}, {}}});
  scene.tasks = {{3, 4}, {9, 4}};
  return scene;
}

std::string Picture(const Scene& scene, PlaceObjective objective = PlaceObjective::kArea) {
  const auto ground =
      PlacementGround::Prepare(scene.world, {.objective = objective, .tasks = scene.tasks, .futures = scene.futures});
  return DrawPlace(scene, *ground, PlaceWinches(*ground, {.job = {.evaluations = 30}, .jobs = 3}));
}

int Count(const std::string& svg, const std::string& part) {
  int count = 0;
  for (std::size_t at = svg.find(part); at != std::string::npos; at = svg.find(part, at + 1)) ++count;
  return count;
}

TEST(DrawPlaceTest, ShowsWinchesStartsAndHowTheBestImproved) {
  const std::string svg = Picture(Hall());
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(svg, HasSubstr("4 winches can move the robot in"));
  EXPECT_THAT(svg, HasSubstr("class=\"workspace\""));
  EXPECT_THAT(svg, HasSubstr("The best so far"));
  EXPECT_THAT(svg, HasSubstr("area (m²)"));
  EXPECT_EQ(Count(svg, "class=\"start\""), 3 * 4) << "of each job";
  EXPECT_EQ(svg, Picture(Hall()));
}

TEST(DrawPlaceTest, SpeaksOfCableAndOfExpectation) {
  EXPECT_THAT(Picture(Hall(), PlaceObjective::kCable), HasSubstr("cable (m)"));
  Scene moving = Hall();
  moving.futures = {{1, {{"post", {{5.5, 3.5}, {6.5, 4}}}}}};
  EXPECT_THAT(Picture(moving), HasSubstr("expected area (m²)"));
}

TEST(DrawPlaceTest, ShowsNothingThatWasNotFound) {
  Scene blocked = Hall();
  blocked.tasks.push_back({5.5, 3.5});
  const std::string svg = Picture(blocked);
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(svg, HasSubstr("a task cannot be held"));
  EXPECT_THAT(svg, HasSubstr("Task 3 (5.5, 3.5) lies inside an obstacle"));
  EXPECT_THAT(svg, Not(HasSubstr("The best so far")));
  EXPECT_THAT(svg, Not(HasSubstr("class=\"workspace\"")));
}

}  // namespace
}  // namespace tautline
