#include "tautline/draw/draw_field.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tautline/draw/xml_check.h"

namespace tautline {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

/// A room of 8 m x 4 m with a block in it.
Scene Room() {
  Scene scene;
  scene.world.outline = {{0, 0}, {8, 0}, {8, 4}, {0, 4}};
  scene.world.obstacles = {{.name = "block", .polygon = PolygonWithHoles{{{3, 1}, {4, 1}, {4, 3}, {3, 3}}, {}}}};
  scene.tether = Tether{{1, 2}, 6, {}};
  scene.goal = {5, 2};
  return scene;
}

std::string Draw(const Scene& scene, const PlanFieldOptions& options) {
  const auto planner = TetherPlanner::Prepare(scene.world).value();
  const auto field = PlanField::Prepare(planner, *scene.tether, *scene.goal, options).value();
  const FieldRow all = field.All();
  return DrawField(scene, planner.space().free_space(),
                   {.from_base = field.from_base(), .grid = field.grid(), .samples = all.samples});
}

/// How many arrows the layer `headings` has: each is two curves.
std::size_t Arrows(const std::string& svg) {
  const std::size_t begin = svg.find("class=\"headings\""), path = svg.find(" d=\"", begin),
                    end = svg.find('"', path + 4);
  return static_cast<std::size_t>(std::count(svg.begin() + static_cast<std::ptrdiff_t>(path),
                                             svg.begin() + static_cast<std::ptrdiff_t>(end), 'M')) /
         2;
}

TEST(DrawField, HasAnArrowForEachPointWithAHeading) {
  const Scene scene = Room();
  const std::string svg = Draw(scene, {.resolution = 0.5});
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(XmlCheck(svg).classes(), IsSupersetOf({"headings", "ground", "markers", "legend"}));
  EXPECT_THAT(XmlCheck(svg).classes(), Not(Contains("other-headings")));
  EXPECT_THAT(svg,
              AllOf(HasSubstr(">base<"), HasSubstr(">goal<"), HasSubstr("planned every 0.5"), Not(HasSubstr("nan"))));
  const auto planner = TetherPlanner::Prepare(scene.world).value();
  const auto field = PlanField::Prepare(planner, *scene.tether, *scene.goal, {.resolution = 0.5}).value();
  EXPECT_EQ(Arrows(svg), field.All().samples.size());
  EXPECT_EQ(svg, Draw(scene, {.resolution = 0.5}));
}

TEST(DrawField, DrawsFurtherClassesLight) {
  const std::string svg = Draw(Room(), {.resolution = 0.5, .classes = 2});
  EXPECT_THAT(XmlCheck(svg).classes(), IsSupersetOf({"headings", "other-headings"}));
  EXPECT_THAT(svg, HasSubstr("in another class"));
}

TEST(DrawField, ThinsArrowsThatWouldTouch) {
  const std::string svg = Draw(Room(), {.resolution = 0.04});
  EXPECT_GT(Arrows(svg), 500u);
  EXPECT_LT(Arrows(svg), 5000u);
}

TEST(DrawField, SaysWhyItIsEmpty) {
  Scene scene = Room();
  scene.goal = {3.5, 2};
  const std::string svg = Draw(scene, {.resolution = 0.5});
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(svg, AllOf(HasSubstr("No field"), HasSubstr("inside an obstacle")));
}

}  // namespace
}  // namespace tautline
