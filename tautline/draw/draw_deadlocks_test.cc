// The pictures of manifolds.
#include "tautline/draw/draw_deadlocks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tautline/draw/draw_best_base.h"
#include "tautline/draw/draw_manifold.h"
#include "tautline/draw/draw_manifold_field.h"
#include "tautline/draw/draw_sheets.h"
#include "tautline/draw/xml_check.h"
#include "tautline/planners/grid_manifold/map_cells.h"

namespace tautline {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

/// A long room whose left end is near the base.
Scene LongRoom(double length) {
  Scene scene;
  scene.world.outline = {{0, 0}, {20, 0}, {20, 5}, {0, 5}};
  scene.tether = Tether{.base = {5, 0.5}, .length = length, .laid = {}};
  return scene;
}

std::string DeadlocksOf(const Scene& scene) {
  const CellGround ground = MakeCellGround(scene.world, {.resolution_m = 1}).value();
  const GridManifold manifold =
      GridManifold::Build(ground, {.base = *ground.CellAt(scene.tether->base), .length_m = scene.tether->length});
  return DrawDeadlocks(scene, manifold, DeadlockAreas(manifold));
}

TEST(DrawDeadlocks, ShowsClosedCellsContactsAndTethers) {
  const std::string svg = DeadlocksOf(LongRoom(12));
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(XmlCheck(svg).classes(), IsSupersetOf({"closed", "reached", "tether"}));
  EXPECT_THAT(svg, AllOf(HasSubstr("Where the tether can lock the robot in"), Not(HasSubstr("nan"))));
  EXPECT_EQ(svg, DeadlocksOf(LongRoom(12)));
}

TEST(DrawDeadlocks, SaysThatThereAreNone) {
  const std::string svg = DeadlocksOf(LongRoom(3));
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(svg, HasSubstr("No contact locks the robot in"));
}

/// A room with a block in the middle, and its manifold.
struct BlockRoom {
  Scene scene;
  CellGround ground;
  GridManifold manifold;

  static Scene MakeScene() {
    Scene scene;
    scene.world.outline = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
    scene.world.obstacles.push_back(
        {.name = "block", .polygon = PolygonWithHoles{{{4, 4}, {6, 4}, {6, 6}, {4, 6}}, {}}});
    scene.tether = Tether{.base = {1.5, 1.5}, .length = 14, .laid = {}};
    scene.goal = Point{8.5, 8.5};
    return scene;
  }

  BlockRoom()
      : scene(MakeScene()),
        ground(MakeCellGround(scene.world, {.resolution_m = 0.5}).value()),
        manifold(GridManifold::Build(ground, {.base = *ground.CellAt(scene.tether->base), .length_m = 14})) {}
};

TEST(DrawManifold, ShadesCellsByTheirClasses) {
  const BlockRoom room;
  const std::string svg = DrawManifold(room.scene, {&room.manifold, ""});
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(XmlCheck(svg).classes(), IsSupersetOf({"classes", "reached"}));
  EXPECT_THAT(svg, HasSubstr(" classes of the tether in a cell"));
}

TEST(DrawManifoldField, ShowsArrowsAndTheWay) {
  const BlockRoom room;
  const ManifoldGoalField field(room.manifold, *room.ground.CellAt(*room.scene.goal));
  const std::string svg = DrawManifoldField(room.scene, room.manifold, field);
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(XmlCheck(svg).classes(), IsSupersetOf({"headings", "other-headings", "robot-path"}));
  const std::string none = DrawManifoldField(room.scene, room.manifold, ManifoldGoalField(room.manifold, {9, 9}));
  EXPECT_EQ(XmlCheck(none).error(), "");
  EXPECT_THAT(none, HasSubstr("the tether does not reach the goal"));
}

TEST(DrawSheets, ShowsThemOverlappedAndUnfolded) {
  const BlockRoom room;
  const auto sheets = SheetsOf(room.manifold, kMostSheetsShown);
  ASSERT_GE(sheets.size(), 2U);
  const std::string svg = DrawSheets(room.scene, sheets, room.ground.names());
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(svg, AllOf(HasSubstr(">overlapped<"), HasSubstr(">1: the empty word<"), HasSubstr("block")));
  EXPECT_EQ(svg, DrawSheets(room.scene, sheets, room.ground.names()));
}

TEST(DrawBestBase, MarksTheBestOfTheCandidates) {
  const BlockRoom room;
  std::vector<BaseTrial> trials;
  for (const GridCell base : CandidateBases(room.ground, BaseCandidates::kLattice, 4)) {
    trials.push_back(TryBase(room.ground, base, {.length_m = 5}));
    trials.back().job = trials.size() - 1;
  }
  for (const BaseObjective objective : {BaseObjective::kArea, BaseObjective::kDeadlock}) {
    const std::string svg = DrawBestBase(room.scene, {&room.ground, RankBases(trials, objective), objective, ""});
    EXPECT_EQ(XmlCheck(svg).error(), "");
    EXPECT_THAT(svg, AllOf(HasSubstr(">best base<"), HasSubstr("The best of 24 bases"), Not(HasSubstr("nan"))));
  }
  EXPECT_THAT(DrawBestBase(room.scene, {&room.ground, {}, BaseObjective::kArea, "none is free"}),
              HasSubstr("none is free"));
}

}  // namespace
}  // namespace tautline
