#include "tautline/draw/draw_reference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tautline/draw/xml_check.h"
#include "tautline/planners/contact_free/select_reference.h"

namespace tautline {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

/// A wall between base and goal, and a robot of some size.
struct Hall {
  Scene scene;
  TautGround ground;

  explicit Hall(double cable_m) : ground(PrepareRobotGround(World(), 0.3).value()) {
    scene.world = World();
    scene.tether = Tether{{0.5, 4.5}, cable_m, Polyline{{0.5, 4.5}, {1.5, 4.5}}};
    scene.goal = Point{6, 4.5};
  }

  static tautline::World World() {
    tautline::World world;
    world.outline = {{0, 0}, {7, 0}, {7, 7}, {0, 7}};
    world.obstacles.push_back({.name = "wall", .polygon = PolygonWithHoles{{{3, 2}, {4, 2}, {4, 6}, {3, 6}}, {}}});
    return world;
  }

  std::string Draw(const std::vector<BaselinePath>& baselines = {}) const {
    const ReferenceTask task{*scene.tether->laid, scene.tether->length, *scene.goal};
    const ReferencePicture picture{.selection = SelectReference(ground, task, {.list = 3}),
                                   .yen = SelectReference(ground, task, {.list = 1}),
                                   .baselines = baselines};
    return DrawReference(scene, ground.space().free_space(), picture);
  }
};

TEST(DrawReference, ShowsTheClassesAndTheOneChosen) {
  const std::string svg = Hall(7.5).Draw();
  EXPECT_THAT(svg, AllOf(HasSubstr("Reference path"), HasSubstr("of 7.50 m"), HasSubstr("too long"),
                         HasSubstr("1 of these 3 classes"), HasSubstr("word: wall")));
  EXPECT_THAT(XmlCheck(svg).classes(), IsSupersetOf({"robot-path", "class", "numbers", "laid-cable"}));
}

TEST(DrawReference, ShowsWhatIsMissing) {
  const std::string svg = Hall(4).Draw();
  EXPECT_THAT(svg, AllOf(HasSubstr("No reference path"), HasSubstr("choose another goal")));
  EXPECT_THAT(XmlCheck(svg).classes(), AllOf(Contains("beyond-limit"), Not(Contains("robot-path"))));
}

TEST(DrawReference, ShowsBaselinesInsteadOfTheOtherClasses) {
  const std::string svg = Hall(9).Draw({{"dijkstra", {{1.5, 4.5}, {3, 6.5}, {6, 4.5}}}, {"voronoi", {{1, 1}, {6, 6}}}});
  EXPECT_THAT(XmlCheck(svg).classes(), AllOf(IsSupersetOf({"dijkstra", "voronoi"}), Not(Contains("class"))));
  EXPECT_THAT(svg, HasSubstr("7.07 m"));
}

}  // namespace
}  // namespace tautline
