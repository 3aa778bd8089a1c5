// The pictures of fleets.
#include "tautline/draw/draw_fleet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tautline/draw/aligned_keyframes.h"
#include "tautline/draw/example_fleet.h"
#include "tautline/draw/fleet_graphs.h"
#include "tautline/draw/xml_check.h"

namespace tautline {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

/// A scene, prepared.
struct Example {
  Scene scene;
  FleetGround ground;
  FleetLayout layout;
};

Example Prepare(Scene scene) {
  auto ground = FleetGround::Prepare(scene).value();
  auto layout = ReadLayout(ground).value();
  return {std::move(scene), std::move(ground), std::move(layout)};
}

const std::vector<std::pair<int, int>> kTriangleOrders = {{1, 0}, {0, 2}, {2, 1}};

std::size_t CountOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(DrawLayout, ShowsCableLinesAndRingsWhatIsWrong) {
  const Example e = Prepare(TriangleScene());
  const LayoutPicture picture{
      .title = "A title", .notes = {"A note."}, .layout = &e.layout, .marks = {{{1, 1}, "r1 and r2 cross"}}};
  const std::string svg = DrawLayout(e.scene, e.ground, picture);
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(XmlCheck(svg).classes(), IsSupersetOf({"ground", "cable-line", "markers", "labels", "legend"}));
  EXPECT_THAT(svg, AllOf(HasSubstr("r1 and r2 cross"), HasSubstr("A note."), HasSubstr("cable line of r3"),
                         Not(HasSubstr("wall or obstacle")), Not(HasSubstr("nan"))));
  EXPECT_EQ(svg, DrawLayout(e.scene, e.ground, picture));
}

TEST(DrawLayout, OfFaultyCablesDrawsThemAsTheSceneHasThem) {
  Scene scene = TriangleScene();
  scene.fleet->robots[0].cable = Polyline{{-6.8, -1.9}, {0, 0}, {6.1, -0.6}};
  const auto ground = FleetGround::Prepare(scene).value();
  const std::string svg =
      DrawLayout(scene, ground, {.title = "No layout", .notes = {}, .layout = nullptr, .marks = {{{0, 0}, "bends"}}});
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_EQ(CountOf(svg, "class=\"cable-line\""), 3u);
}

TEST(DrawLayout, OfAWorldHasItsObstacles) {
  Scene scene = TriangleScene();
  scene.world.outline = {{-9, -9}, {9, -9}, {9, 9}, {-9, 9}};
  scene.world.obstacles.push_back({.name = "block", .polygon = PolygonWithHoles{{{7, 7}, {8, 7}, {8, 8}}, {}}});
  const Example e = Prepare(scene);
  const std::string svg = DrawLayout(e.scene, e.ground, {.title = "", .notes = {}, .layout = &e.layout, .marks = {}});
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(svg, AllOf(HasSubstr("wall or obstacle"), HasSubstr(">block<")));
}

TEST(DrawLayout, OfManyFaultsExplainsNone) {
  const Example e = Prepare(TriangleScene());
  const LayoutPicture picture{
      .title = "", .notes = {}, .layout = &e.layout, .marks = std::vector<LayoutMark>(50, {{1, 1}, "r1 and r2 cross"})};
  EXPECT_THAT(DrawLayout(e.scene, e.ground, picture), Not(HasSubstr("r1 and r2 cross")));
}

TEST(DrawLayouts, AreAtMostTwelve) {
  const Example e = Prepare(TriangleScene());
  const std::vector<const FleetLayout*> layouts(15, &e.layout);
  const std::string svg = DrawLayouts(e.scene, e.ground, {.title = "15 layouts", .notes = {}, .layouts = layouts});
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_EQ(CountOf(svg, "class=\"panel\""), 12u);
  EXPECT_THAT(svg, HasSubstr("12: 4"));
}

TEST(DrawFleetPlan, ShowsPathsGraphsAndSchedule) {
  const Example e = Prepare(TriangleScene());
  FleetPlan plan = HandMadePlan(e.ground, kTriangleOrders);
  const std::string svg = DrawFleetPlan(e.scene, e.ground, {.layout = e.layout, .plan = plan});
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(XmlCheck(svg).classes(),
              IsSupersetOf({"cable-line", "path", "crossings", "pair-graph", "event-graph", "schedule"}));
  EXPECT_THAT(svg, AllOf(HasSubstr("3 robots, straight-concurrent"), HasSubstr("bent-sequential"),
                         HasSubstr("time (s)"), Not(HasSubstr("nan"))));
  EXPECT_EQ(svg, DrawFleetPlan(e.scene, e.ground, {.layout = e.layout, .plan = plan}));
}

TEST(DrawFleetPlan, TellsOfDeadlocksAndDetours) {
  const Example e = Prepare(TriangleScene());
  FleetPlan plan = HandMadePlan(e.ground, {{1, 0}});
  plan.pair_deadlocks = {{RobotId(1), RobotId(2)}};
  plan.network_deadlocks = {{RobotId(0), RobotId(1)}};
  plan.entangled = {{RobotId(2)}};
  plan.detours = {RobotId(2)};
  plan.schedule[2].path = {
      .route = e.layout[2], .points = PointsOf(e.ground, e.layout[2]), .along = {0, 1, 2}, .is_cable = true};
  plan.modes[1] = {.realizable = false, .detours = {RobotId(2)}, .travel_time = 1, .travel_distance = 2};
  const std::string svg = DrawFleetPlan(e.scene, e.ground, {.layout = e.layout, .plan = plan});
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(XmlCheck(svg).classes(), Contains("detour"));
  EXPECT_THAT(svg, AllOf(HasSubstr("Pair deadlock of r2 and r3"), HasSubstr("r1 and r2 would wait for each other"),
                         HasSubstr("r3 would make another layout"), HasSubstr("r3 must follow its cable line"),
                         HasSubstr("2.00 m, with a detour")));
}

TEST(DrawFleetPlan, OfARobotAlone) {
  const Example e = Prepare(CrowdScene(1));
  const FleetPlan plan = HandMadePlan(e.ground, {});
  const std::string svg = DrawFleetPlan(e.scene, e.ground, {.layout = e.layout, .plan = plan});
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(XmlCheck(svg).classes(), Not(Contains("pair-graph")));
  EXPECT_THAT(svg, AllOf(HasSubstr("One robot"), Not(HasSubstr("nan")), Not(HasSubstr("inf"))));
}

TEST(DrawFleetPlan, OfAThousandRobotsLeavesTheGraphsOut) {
  const Example e = Prepare(CrowdScene(1000));
  const FleetPlan plan = HandMadePlan(e.ground, {});
  const std::string svg = DrawFleetPlan(e.scene, e.ground, {.layout = e.layout, .plan = plan});
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(XmlCheck(svg).classes(), Not(Contains("event-graph")));
  EXPECT_THAT(svg, AllOf(HasSubstr("the graphs are not drawn"), HasSubstr("the 40 robots that wait or drive longest")));
  EXPECT_LT(svg.size(), 1'500'000u);
}

TEST(EventGraphDrawing, HasACircleWhereNoOrderIsPossible) {
  const Example e = Prepare(TriangleScene());
  EXPECT_FALSE(EventGraphDrawing(HandMadePlan(e.ground, kTriangleOrders)).has_circle());
  EXPECT_EQ(EventGraphDrawing(HandMadePlan(e.ground, kTriangleOrders)).rows(), 3u);
  FleetPlan plan = HandMadePlan(e.ground, {});
  // r1 passes A before B, r2 passes B before A; A asks r2 to be first, B asks r1.
  plan.passings = {{.first = RobotId(1), .second = RobotId(0), .label = "A", .first_along = 2, .second_along = 1},
                   {.first = RobotId(0), .second = RobotId(1), .label = "B", .first_along = 2, .second_along = 1}};
  EXPECT_TRUE(EventGraphDrawing(plan).has_circle());
}

TEST(DrawSimulate, DrawsDifferencesRed) {
  const Example e = Prepare(TriangleScene());
  Playback playback{.final_routes = e.layout, .longest = {{14, 3}, {13, 2}, {12, 1}}, .frames = {}, .words_agree = {}};
  EXPECT_THAT(
      DrawSimulate(e.scene, e.ground, {.layout = e.layout, .playback = playback}),
      AllOf(HasSubstr("The layout came out"), HasSubstr("at most 14.00 m at 3 s"), Not(HasSubstr("lies differently"))));
  playback.final_routes[1] = {e.layout[1].front(), e.layout[1].back()};
  playback.differing = {RobotId(1)};
  const std::string svg = DrawSimulate(e.scene, e.ground, {.layout = e.layout, .playback = playback});
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(XmlCheck(svg).classes(), IsSupersetOf({"wanted", "final-cable"}));
  EXPECT_THAT(svg, HasSubstr("The layout did not come out: the cable of r2 lies differently"));
  playback.broken = {{RobotId(0), RobotId(2), {1, 2}}};
  EXPECT_THAT(DrawSimulate(e.scene, e.ground, {.layout = {}, .playback = playback}), HasSubstr("r3 passed before r1"));
}

TEST(AlignedKeyframes, HaveAsManyPointsAsTheLongestLine) {
  const std::vector<Polyline> lines = {{{0, 0}, {0, 0}}, {{0, 0}, {4, 0}}, {{0, 0}, {4, 1}, {8, 0}}, {{0, 0}, {9, 0}}};
  const std::vector<Polyline> aligned = AlignedKeyframes(lines);
  const std::vector<Polyline> wanted = {
      {{0, 0}, {0, 0}, {0, 0}}, {{0, 0}, {4, 0}, {4, 0}}, {{0, 0}, {4, 1}, {8, 0}}, {{0, 0}, {0, 0}, {9, 0}}};
  EXPECT_EQ(aligned[1], wanted[1]);
  EXPECT_EQ(aligned[2], wanted[2]);
  EXPECT_EQ(aligned[3], wanted[3]);
  EXPECT_EQ(aligned[0], wanted[0]);
}

TEST(AnimateFleet, MovesRobotsAndCables) {
  const Example e = Prepare(TriangleScene());
  const FleetPlan plan = HandMadePlan(e.ground, kTriangleOrders);
  const auto frames = HandMadeFrames(e.ground, e.layout, plan, 20);
  const FleetFilm film{.layout = e.layout, .plan = plan, .frames = frames};
  const std::string svg = AnimateFleet(e.scene, e.ground, film);
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(XmlCheck(svg).classes(), IsSupersetOf({"moving-cables", "moving-robots", "clock", "schedule"}));
  EXPECT_EQ(CountOf(svg, "attributeName=\"points\""), 4u);  // Three cables and the line over the schedule.
  EXPECT_EQ(CountOf(svg, "attributeName=\"cx\""), 3u);
  EXPECT_EQ(svg, AnimateFleet(e.scene, e.ground, film));
}

TEST(AnimateFleet, OfAMomentStandsStill) {
  const Example e = Prepare(CrowdScene(2));
  const FleetPlan plan = HandMadePlan(e.ground, {});
  const std::vector<PlaybackFrame> frames = {HandMadeFrames(e.ground, e.layout, plan, 2)[0]};
  const std::string svg = AnimateFleet(e.scene, e.ground, {.layout = e.layout, .plan = plan, .frames = frames});
  EXPECT_EQ(XmlCheck(svg).error(), "");
  EXPECT_THAT(svg, AllOf(Not(HasSubstr("nan")), Not(HasSubstr("inf"))));
}

}  // namespace
}  // namespace tautline
