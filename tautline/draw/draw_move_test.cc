// The pictures of motions and tours.
#include "tautline/draw/draw_move.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tautline/draw/draw_tour.h"
#include "tautline/draw/xml_check.h"

namespace tautline {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

/// A square room with a block in the middle; the cables lie below it.
struct Room {
  Scene scene;
  CableGround ground;
  Anchors anchors;
  WorkspaceBoundary boundary;

  const FreeSpace& space() const { return ground.space().free_space(); }
};

Room BlockRoom() {
  Scene scene;
  scene.world.outline = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  scene.world.obstacles.push_back({.name = "block", .polygon = PolygonWithHoles{{{4, 4}, {6, 4}, {6, 6}, {4, 6}}, {}}});
  scene.cables = Cables{.anchors = {{0, 0}, {0, 10}, {10, 10}, {10, 0}}, .laid = std::vector<Polyline>()};
  for (const Point p : scene.cables->anchors) scene.cables->laid->push_back({{5, 1}, p});
  auto ground = CableGround::Prepare(scene.world).value();
  auto anchors = PlaceAnchors(ground, scene.cables->anchors).value();
  auto boundary = BoundaryOfCables(ground, anchors, *scene.cables->laid).value();
  return {std::move(scene), std::move(ground), std::move(anchors), std::move(boundary)};
}

std::string MoveIn(const Room& room, Point start, Point goal, const MoveOptions& options = {}) {
  const WorkspaceRegion region(room.ground, room.anchors, room.boundary);
  const auto move = PlanMove(region, start, goal, options);
  return DrawMove(room.scene, room.space(),
                  {.anchors = room.anchors,
                   .boundary = room.boundary,
                   .start = start,
                   .goal = goal,
                   .options = options,
                   .move = move});
}

std::string TourOf(const Room& room, const TourStops& stops, const TourOptions& options = {}) {
  const WorkspaceRegion region(room.ground, room.anchors, room.boundary);
  Rng rng(1);
  const auto tour = PlanTour(region, stops, options, rng);
  return DrawTour(room.scene, room.space(),
                  {.anchors = room.anchors, .boundary = room.boundary, .stops = stops, .tour = tour});
}

TEST(DrawMove, ShowsPathCablesAndBothPlots) {
  const std::string svg = MoveIn(BlockRoom(), {1, 7}, {9, 7}, {.acceleration = 1, .winch_limits = {0.5}});
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(XmlCheck(svg).classes(),
              IsSupersetOf({"workspace", "boundary", "robot-path", "cable", "later-cable", "plot", "series"}));
  EXPECT_THAT(svg, AllOf(HasSubstr("Robot path 10.49 m"), HasSubstr(">Cable lengths<"), HasSubstr(">Cable rates<"),
                         HasSubstr(">winch 4<"), HasSubstr(">limit<"), HasSubstr(">turn<")));
  EXPECT_EQ(svg, MoveIn(BlockRoom(), {1, 7}, {9, 7}, {.acceleration = 1, .winch_limits = {0.5}}));
}

TEST(DrawMove, OfARobotThatStays) {
  const std::string svg = MoveIn(BlockRoom(), {5, 1}, {5, 1});
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(svg, AllOf(Not(HasSubstr("nan")), Not(HasSubstr("inf"))));
}

TEST(DrawMove, SaysWhatIsOutside) {
  EXPECT_THAT(MoveIn(BlockRoom(), {5, 8}, {5, 1}), HasSubstr("the start is outside of the workspace"));
  EXPECT_THAT(MoveIn(BlockRoom(), {5, 1}, {5, 8}),
              AllOf(HasSubstr("the goal is outside of the workspace"), HasSubstr("The goal (5, 8) is outside")));
}

TEST(DrawTour, NumbersTheTasksByTheOrderOfTheVisit) {
  const std::string svg = TourOf(BlockRoom(), {{5, 1}, {{9, 1}, {1, 1}, {9, 1}}, Point{5, 3}});
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(XmlCheck(svg).classes(), IsSupersetOf({"workspace", "robot-path", "numbers"}));
  EXPECT_THAT(svg, AllOf(HasSubstr("The shortest tour over 3 tasks"), HasSubstr(">goal<"), HasSubstr(">3<")));
}

TEST(DrawTour, OfManyTasksHasNoNumbersAndTellsTheBound) {
  TourStops stops{{5, 1}, {}, {}};
  for (int i = 0; i < 81; ++i) stops.tasks.push_back({0.5 + i % 9, 0.2 + 0.3 * (i / 9)});
  const std::string svg = TourOf(BlockRoom(), stops, {.rounds_per_task = 1});
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(XmlCheck(svg).classes(), Not(Contains("numbers")));
}

TEST(DrawTour, SaysWhatIsOutside) {
  const std::string svg = TourOf(BlockRoom(), {{5, 1}, {{5, 8}, {5, 2}, {5, 9}}, {}});
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(svg,
              AllOf(HasSubstr("2 tasks are outside"), HasSubstr("Task 1 (5, 8) is outside"), HasSubstr(">task 3<")));
  EXPECT_THAT(TourOf(BlockRoom(), {{5, 8}, {}, {}}), HasSubstr("the start is outside"));
}

}  // namespace
}  // namespace tautline
