#include "tautline/planners/fleet/tracks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/planners/fleet/check_layout.h"
#include "tautline/planners/fleet/random_fleet.h"
#include "tautline/planners/fleet/track_crossings.h"

namespace tautline {
namespace {

FleetRobot Robot(const std::string& name, Point start, Point target) {
  FleetRobot robot;
  robot.name = name;
  robot.start = start;
  robot.target = target;
  robot.speed = 1;
  return robot;
}

FleetGround GroundOf(std::vector<FleetRobot> robots) {
  Scene scene;
  scene.fleet = Fleet{std::move(robots)};
  return *FleetGround::Prepare(scene);
}

/// How often tracks cross, for each pair that does.
std::size_t CrossingsOf(const std::vector<Polyline>& lines) {
  std::vector<std::vector<double>> along;
  for (const Polyline& line : lines) {
    std::vector<double>& lengths = along.emplace_back(std::vector<double>{0});
    for (std::size_t i = 1; i < line.size(); ++i) lengths.push_back(lengths.back() + Distance(line[i - 1], line[i]));
  }
  std::vector<Track> tracks;
  for (std::size_t i = 0; i < lines.size(); ++i) tracks.push_back({lines[i], along[i]});
  return FindTrackCrossings(tracks).size();
}

//   r1 and r2 share the way between the targets of r3 and r4, and part to sides of which one makes them cross.
//
//       2'                       r1: 1 - 3' - 4' - 1'
//        `                       r2: 2 - 3' - 4' - 2'
//  1 ----- 3' ------- 4' ---- 1'
//         ^             `
//     2 -                  2'
TEST(Tracks, SharedPartsCrossOnceOrNotAtAll) {
  for (const bool up : {false, true}) {
    const FleetGround ground = GroundOf({Robot("r1", {0, 0}, {10, up ? 1.0 : -1.0}), Robot("r2", {0, -2}, {10, 3}),
                                         Robot("r3", {3, 9}, {3, 0.5}), Robot("r4", {6, 9}, {6, 0.5})});
    const auto line = [&](std::size_t robot) {
      return *ReadRoute(ground, RobotId(robot),
                        Polyline{ground.robots()[robot].start, {3, 0.5}, {6, 0.5}, ground.robots()[robot].target});
    };
    std::vector<Route> routes{line(0), line(1)};
    const std::vector<Polyline> tracks = SideBySide(ground, routes, {.spacing = 0.1});
    ASSERT_EQ(tracks[0].size(), 4u);
    EXPECT_EQ(tracks[0].front(), (Point{0, 0}));
    EXPECT_EQ(tracks[1].back(), (Point{10, 3}));
    SCOPED_TRACE(up ? "up" : "down");
    EXPECT_EQ(CrossingsOf(tracks), CrossingsOf(SideBySide(ground, routes)));
  }
}

TEST(Tracks, NestedAroundOneNode) {
  const FleetGround ground =
      GroundOf({Robot("r1", {0, 3}, {8, 3}), Robot("r2", {1, 4}, {7, 4}), Robot("r3", {4, 9}, {4, 0})});
  std::vector<Route> routes;
  for (const std::size_t i : {0, 1}) {
    routes.push_back(
        *ReadRoute(ground, RobotId(i), Polyline{ground.robots()[i].start, {4, 0}, ground.robots()[i].target}));
  }
  const std::vector<Polyline> tracks = SideBySide(ground, routes, {.spacing = 0.1});
  EXPECT_LT(tracks[0][1].y, tracks[1][1].y) << "the sharper bend is the inner one";
  EXPECT_LT(tracks[1][1].y, 0);
  EXPECT_EQ(CrossingsOf(tracks), 0u);
}

TEST(Tracks, TracksCrossWhereLayoutsDo) {
  const std::int64_t count = ScaledTestCount(20000);
  std::int64_t compared = 0, crossing = 0;
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const bool on_lattice = rng.UniformInt(0, 2) > 0;
    const Scene scene = RandomFleet(rng, rng.UniformInt(2, 6), on_lattice ? 4 : 10, on_lattice);
    const auto ground = FleetGround::Prepare(scene);
    ASSERT_TRUE(ground.has_value());
    FleetLayout layout;
    for (std::size_t i = 0; i < ground->size(); ++i) {
      const auto route = RandomRoute(rng, *ground, RobotId(i), 3);
      if (!route) break;
      layout.push_back(*route);
    }
    if (layout.size() < ground->size()) continue;
    const std::size_t crossings = CrossingsOf(SideBySide(*ground, layout));
    const LayoutFaults faults = CheckLayout(*ground, layout);
    ++compared;
    crossing += crossings > 0 ? 1 : 0;
    ASSERT_EQ(crossings == 0, faults.crossings.empty());
  }
  EXPECT_GT(compared, count / 4);
  EXPECT_GT(crossing, compared / 10);
  EXPECT_LT(crossing, compared * 99 / 100);
}

}  // namespace
}  // namespace tautline
