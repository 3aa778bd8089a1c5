#include "bench/peers/boundary_loops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "bench/cable_rooms.h"
#include "tautline/planners/cable_workspace/best.h"

namespace tautline {
namespace {

std::vector<double> SortedAreas(const std::vector<WorkspaceBoundary>& boundaries) {
  std::vector<double> areas;
  for (const WorkspaceBoundary& boundary : boundaries) areas.push_back(boundary.area);
  std::sort(areas.begin(), areas.end());
  return areas;
}

TEST(BoundaryLoopsTest, TheLoopsFindTheBoundariesOfTheLibrary) {
  std::size_t boundaries = 0;
  for (const CableRoom& room : {ThreeObstacleRoom(), RandomCableRoom({.anchors = 3, .obstacles = 4}),
                                RandomCableRoom({.anchors = 4, .obstacles = 4})}) {
    const PreparedCableRoom prepared(room);
    const double limit = 1.1 * prepared.shortest;
    const BoundaryList list = FindBoundaries(prepared.ground, prepared.anchors, {.max_boundary = limit});
    ASSERT_TRUE(list.complete);
    boundaries += list.boundaries.size();
    const auto sides = ListSides(prepared.ground, prepared.anchors, limit);
    for (const Multiply multiply : {Multiply::kWhole, Multiply::kPartial}) {
      const LoopedBoundaries looped =
          LoopOverSides(prepared.ground, prepared.anchors, sides, limit, multiply, 100'000'000);
      EXPECT_FALSE(looped.gave_up);
      const auto expected = SortedAreas(list.boundaries), found = SortedAreas(looped.boundaries);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-6 * expected[i]);
    }
  }
  EXPECT_GT(boundaries, 10u);
}

TEST(BoundaryLoopsTest, GivesUpAtItsLimit) {
  const PreparedCableRoom room(ThreeObstacleRoom());
  const auto sides = ListSides(room.ground, room.anchors, 1100);
  const auto looped = LoopOverSides(room.ground, room.anchors, sides, 1100, Multiply::kWhole, 100);
  EXPECT_TRUE(looped.gave_up);
}

}  // namespace
}  // namespace tautline
