// The pictures of manifolds: deadlocks.
#include "tautline/draw/draw_deadlocks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace tautline
