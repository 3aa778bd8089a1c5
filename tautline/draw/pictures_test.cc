// What every picture of this folder must hold: well-formed, reproducible, with the layers that
// belong to it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tautline/draw/blocked_parts.h"
#include "tautline/draw/example_pictures.h"
#include "tautline/draw/xml_check.h"

namespace tautline {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

using Classes = std::set<std::string>;

std::string ExamplePlan() {
  const Example room = Room();
  return DrawPlan(room.scene, room.space, RoomPlan());
}

std::string Find(const std::string& name) {
  for (const NamedPicture& picture : ExamplePictures()) {
    if (picture.name == name) return picture.svg;
  }
  return "";
}

TEST(Pictures, AreWellFormed) {
  for (const NamedPicture& picture : ExamplePictures()) {
    EXPECT_EQ(XmlCheck(picture.svg).error(), "") << picture.name;
    EXPECT_THAT(picture.svg, Not(HasSubstr("nan"))) << picture.name;
    EXPECT_THAT(picture.svg, Not(HasSubstr("inf"))) << picture.name;
  }
}

TEST(Pictures, AreTheSameBytesEachTime) {
  const std::vector<NamedPicture> first = ExamplePictures(), second = ExamplePictures();
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].svg, second[i].svg) << first[i].name;
}

TEST(Pictures, HaveTheCommonLayers) {
  for (const NamedPicture& picture : ExamplePictures()) {
    EXPECT_THAT(XmlCheck(picture.svg).classes(),
                IsSupersetOf({"ground", "names", "markers", "labels", "title", "scale-bar", "legend"}))
        << picture.name;
  }
}

TEST(DrawPlan, ShowsPathTethersCableAndRejectedPath) {
  const std::string svg = ExamplePlan();
  EXPECT_THAT(XmlCheck(svg).classes(),
              IsSupersetOf({"tether-goal", "tether-start", "rejected", "robot-path", "laid-cable"}));
  EXPECT_THAT(svg, HasSubstr("robot path 23.39 m"));
  EXPECT_THAT(svg, HasSubstr("needs 21.01 m of tether"));
  EXPECT_THAT(svg, AllOf(HasSubstr(">base<"), HasSubstr(">robot<"), HasSubstr(">goal<"), HasSubstr(">pillar<")));
}

TEST(DrawPlan, TheLegendTellsOnlyOfWhatIsDrawn) {
  Example room = Room();
  room.scene.tether->laid.reset();
  PlanResult result = RoomPlan();
  result.rejected.reset();
  const std::string svg = DrawPlan(room.scene, room.space, result);
  EXPECT_THAT(svg, Not(HasSubstr("cable as laid")));
  EXPECT_THAT(svg, Not(HasSubstr("rejected")));
}

TEST(DrawPlan, NearTiesAreToldApart) {
  const Example room = Room();
  PlanResult result = RoomPlan();
  result.rejected->tether.length = result.limit + 0.0003;
  EXPECT_THAT(DrawPlan(room.scene, room.space, result),
              AllOf(HasSubstr("needs 18.0003 m of tether,"), HasSubstr("limit 18.0000 m")));
}

TEST(DrawPlan, SaysWhyThereIsNone) {
  EXPECT_THAT(Find("plan_too_short"), AllOf(HasSubstr("17.10 m of tether"), HasSubstr("the tether ends here")));
  EXPECT_THAT(XmlCheck(Find("plan_too_short")).classes(), Contains("beyond-limit"));
  EXPECT_THAT(XmlCheck(Find("plan_laid_too_long")).classes(), Contains("beyond-limit"));
  EXPECT_THAT(XmlCheck(Find("plan_laid_blocked")).classes(), Contains("blocked-part"));
  EXPECT_THAT(Find("plan_goal_blocked"), HasSubstr("the goal lies on blocked ground"));
  EXPECT_THAT(Find("plan_unreachable"), HasSubstr("the piece of the goal"));
}

TEST(DrawPlan, AllClassesAreNumbered) {
  EXPECT_THAT(XmlCheck(Find("plan_all")).classes(), IsSupersetOf({"class", "numbers"}));
}

TEST(DrawPlan, ScaledWorldsLookAlike) {
  const std::string plan = ExamplePlan(), tiny = Find("plan_tiny");
  EXPECT_EQ(XmlCheck(plan).elements(), XmlCheck(tiny).elements());
  EXPECT_THAT(tiny, HasSubstr("500 µm"));
  EXPECT_THAT(Find("plan_huge"), HasSubstr("500 km"));
}

TEST(DrawPlan, AnEmptyFreeSpaceIsAllBlocked) {
  const std::string svg = DrawPlan({}, {}, {});
  EXPECT_EQ(XmlCheck(svg).error(), "");
}

TEST(DrawClasses, ListsLengthsAndWords) {
  const std::string svg = Find("classes");
  EXPECT_THAT(svg, AllOf(HasSubstr("15 homotopy classes"), HasSubstr("word: pillar cart"), HasSubstr("3 more")));
  EXPECT_THAT(XmlCheck(svg).classes(), IsSupersetOf({"class", "other-class", "numbers"}));
}

TEST(DrawClasses, NoneAtAll) {
  const Example room = Room();
  const std::string svg = DrawClasses(room.scene, room.space, {.from = {1, 1}, .to = {18, 2}, .list = {}});
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(svg, HasSubstr("No class"));
}

TEST(DrawReach, DrawsArcsAsArcs) {
  const std::string svg = Find("reach");
  EXPECT_THAT(XmlCheck(svg).classes(), IsSupersetOf({"region", "reach-end", "tether"}));
  EXPECT_THAT(svg, ContainsRegex("class=\"reach-end\"[^/]*d=\"M[^\"]*a[0-9.]+ [0-9.]+ 0 0 0 "));
  EXPECT_THAT(svg,
              AllOf(HasSubstr("A tether of 9.00 m reaches"), HasSubstr("within reach"), HasSubstr("out of reach")));
  EXPECT_THAT(XmlCheck(svg).classes(), Not(Contains("sheet")));
}

TEST(DrawReach, ShadesSheets) {
  const std::string svg = Find("reach_sheets");
  EXPECT_THAT(XmlCheck(svg).classes(), IsSupersetOf({"sheet", "sheet-end", "ray"}));
  EXPECT_THAT(svg, AllOf(HasSubstr("within reach in 1 class"), HasSubstr("in 2 classes"), HasSubstr("fill-opacity")));
  EXPECT_THAT(Find("reach_stopped"), HasSubstr("stopped after its budget of 20 taut walks"));
  EXPECT_THAT(XmlCheck(Find("reach_stopped")).classes(), Not(Contains("sheet")));
}

TEST(DrawReach, ShowsThePointAndWhatItNeeds) {
  EXPECT_THAT(Find("reach_at"), AllOf(HasSubstr("least tether to the point 16."), HasSubstr("the tether ends here")));
  EXPECT_THAT(Find("reach_at_blocked"), HasSubstr("the point (5, 5) lies inside"));
  EXPECT_THAT(Find("reach_blocked"), HasSubstr("the base lies on blocked ground"));
}

TEST(DrawTaut, ShowsTheRaysOfTheWord) {
  EXPECT_THAT(XmlCheck(Find("taut")).classes(), IsSupersetOf({"taut", "laid-cable", "ray"}));
}

TEST(DrawShow, TellsPiecesMergesAndSnaps) {
  const std::string svg = Find("show");
  EXPECT_THAT(svg, AllOf(HasSubstr("3 separate pieces"), HasSubstr("crates + pallet + o7"), HasSubstr("wall + wall10"),
                         HasSubstr("1 boundary vertex joined"), HasSubstr("a long cupboard &lt;&amp;&quot;&gt;")));
}

TEST(DrawShow, ManySpecksGetFewNames) {
  const std::string svg = Find("show_specks");
  EXPECT_THAT(svg, HasSubstr("432 obstacles"));
  EXPECT_THAT(svg, Not(HasSubstr(">o2<")));
}

TEST(BlockedParts, FromWhereTheLineEntersToWhereItLeaves) {
  const Example room = Room();
  const Polyline line = {{1, 5}, {5, 5}, {10, 5}};
  const std::vector<Polyline> parts = BlockedParts(room.space, line);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_NEAR(parts[0].front().x, 3.7, 1e-9);
  EXPECT_NEAR(parts[0].back().x, 6.3, 1e-9);
}

TEST(BlockedParts, TouchingIsAllowed) {
  const Example room = Room();
  const Polyline line = {{1, 6.3}, {10, 6.3}};
  EXPECT_TRUE(BlockedParts(room.space, line).empty());
}

}  // namespace
}  // namespace tautline
