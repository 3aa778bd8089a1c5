#include "tautline/planners/contact_free/track_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tautline/base/test_scale.h"
#include "tautline/homotopy/classes.h"
#include "tautline/planners/contact_free/random_robot_ground.h"

namespace tautline {
namespace {

constexpr double kPi = std::numbers::pi;

/// The distance from p to a polyline.
double DistanceTo(const Polyline& path, Point p) {
  double least = Distance(p, path[0]);
  for (std::size_t i = 1; i < path.size(); ++i) least = std::min(least, DistanceToSegment(p, path[i - 1], path[i]));
  return least;
}

/// Drives without an environment, as a unicycle does [Shimada2024, Eq. 5].
Polyline DriveFreely(const Polyline& path, RobotPose pose, double lookahead_m, int steps) {
  PurePursuit pursuit(path);
  Polyline driven{pose.at};
  for (int i = 0; i < steps; ++i) {
    pursuit.MoveOn(pose.at, 1);
    const Velocity command = pursuit.Steer(pose, lookahead_m);
    EXPECT_LE(std::abs(command.turn_rad_per_s), 2 + 1e-12);
    EXPECT_LE(command.speed_m_per_s, 1 + 1e-12);
    pose.at = pose.at + 0.1 * command.speed_m_per_s * Point{std::cos(pose.heading_rad), std::sin(pose.heading_rad)};
    pose.heading_rad = std::remainder(pose.heading_rad + 0.1 * command.turn_rad_per_s, 2 * kPi);
    driven.push_back(pose.at);
  }
  return driven;
}

TEST(PurePursuit, SteersAlongTheArcToItsTarget) {
  const PurePursuit straight({{0, 0}, {10, 0}});
  EXPECT_EQ(straight.Steer({{0, 0}, 0}, 1).turn_rad_per_s, 0);
  EXPECT_EQ(straight.Steer({{0, 0}, 0}, 1).speed_m_per_s, 1);
  // The target (1, 0) lies 60 degrees to the right: the arc has curvature 2 sin(60 degrees) / 1.
  const Velocity right = straight.Steer({{0, 0}, kPi / 3}, 1);
  EXPECT_NEAR(right.turn_rad_per_s / right.speed_m_per_s, -std::sqrt(3.0), 1e-12);
  // 2 rad/s at most: it goes slower on tighter arcs.
  const Velocity tight = straight.Steer({{0, 0}, kPi / 3}, 0.2);
  EXPECT_NEAR(tight.turn_rad_per_s, -2, 1e-12);
  EXPECT_NEAR(tight.turn_rad_per_s / tight.speed_m_per_s, -5 * std::sqrt(3.0), 1e-9);
}

TEST(PurePursuit, TurnsOnTheSpotWhereItsTargetIsBehind) {
  const PurePursuit pursuit({{0, 0}, {10, 0}});
  EXPECT_EQ(pursuit.Steer({{0, 0}, 3}, 1).speed_m_per_s, 0);
  EXPECT_EQ(pursuit.Steer({{0, 0}, 3}, 1).turn_rad_per_s, -2);
  EXPECT_EQ(pursuit.Steer({{0, 0}, -3}, 1).turn_rad_per_s, 2);
}

TEST(PurePursuit, KeepsToItsPath) {
  // A figure of eight, whose way is not that of the nearest point.
  Polyline eight;
  for (int i = 0; i <= 80; ++i) {
    const double t = 2 * kPi * i / 80;
    eight.push_back({6 * std::sin(t), 3 * std::sin(2 * t)});
  }
  const Polyline driven = DriveFreely(eight, {eight[0], 0}, 0.5, 600);
  for (const Point p : driven) EXPECT_LE(DistanceTo(eight, p), 0.15);
  EXPECT_LE(Distance(driven.back(), eight.back()), 1e-3);
  EXPECT_NEAR(Length(driven), Length(eight), 0.03 * Length(eight));
}

TEST(PurePursuit, StopsAtTheEnd) {
  const Polyline driven = DriveFreely({{0, 0}, {1, 0}, {1, 0}, {1, 1}}, {{0, 0}, 0}, 0.3, 100);
  EXPECT_LE(Distance(driven.back(), {1, 1}), 1e-5);
  EXPECT_EQ(DriveFreely({{2, 3}}, {{2, 3}, 0}, 0.3, 5).back(), (Point{2, 3}));
}

/// Whether a segment crosses a boundary or begins in blocked ground, edge by edge.
bool BruteTouches(const FreeSpace& space, Point a, Point b) {
  for (const Ring& ring : RingsOf(space)) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point c = ring[i], d = ring[(i + 1) % ring.size()];
      if (CrossProperly(a, b, c, d) || OnSegment(a, b, c) || OnSegment(c, d, a) || OnSegment(c, d, b)) return true;
    }
  }
  return !ComponentOf(space, a).has_value();
}

bool BruteTouches(const FreeSpace& space, const Polyline& cable) {
  for (std::size_t i = 1; i < cable.size(); ++i) {
    if (BruteTouches(space, cable[i - 1], cable[i])) return true;
  }
  return false;
}

TEST(TrackPath, DrivesTautPathsToTheirGoals) {
  Rng rng(841);
  int drives = 0, successes = 0, touching = 0;
  for (std::int64_t trial = 0; trial < ScaledTestCount(60); ++trial) {
    SCOPED_TRACE(trial);
    const RobotGround scene = MakeRobotGround(rng, 0.25);
    const TautSpace& space = scene.ground.space();
    const FreeSpace& floor = scene.ground.ungrown_space();
    const ContactMap map(floor, 0.1);
    for (const TautPath& path : FindClasses(space, scene.from, scene.to, {.max_count = 2}).classes) {
      auto env =
          TetherEnv::Create(map, {.laid = {scene.from}, .cable_length_m = path.length + 2, .goal = scene.to},
                            {.robot_radius_m = 0.25, .link_length_m = 0.5, .goal_radius_m = 0.1, .max_steps = 2000});
      ASSERT_TRUE(env) << ToString(env.error());
      const TrackResult result = TrackPath(*env, path.points, {.cable_every = 1});
      ++drives;
      EXPECT_EQ(result.trace.size(), static_cast<std::size_t>(result.steps) + 1);
      EXPECT_NEAR(result.time_s, 0.1 * result.steps, 1e-9);
      Polyline driven;
      for (const RobotPose& pose : result.trace) {
        EXPECT_LE(DistanceTo(path.points, pose.at), 0.5);
        driven.push_back(pose.at);
      }
      EXPECT_NEAR(Length(driven), result.driven_m, 1e-9);
      int contacts = 0;
      for (std::size_t i = 1; i < result.cables.size(); ++i) contacts += BruteTouches(floor, result.cables[i]) ? 1 : 0;
      EXPECT_EQ(contacts, result.cable_obstacle_steps);
      EXPECT_NEAR(result.PerMinute(contacts) * result.time_s / 60, contacts, 1e-9);
      if (contacts > 0) ++touching;
      if (!result.success()) continue;
      ++successes;
      driven.push_back(scene.to);
      // A path may pass by its goal, and the drive ends there.
      if (result.driven_m < 0.8 * path.length - 0.2) continue;
      EXPECT_EQ(space.rays().WordOf(driven), path.word);
      EXPECT_LE(Distance(result.trace.back().at, scene.to), 0.1);
    }
  }
  EXPECT_GE(successes, drives * 95 / 100) << drives;
  // Taut paths bend around corners, and the cable behind the robot cuts them.
  EXPECT_GT(touching, 0);
}

TEST(TrackPath, SaysWhyItEnded) {
  World world{.outline = {{0, 0}, {12, 0}, {12, 6}, {0, 6}}};
  world.obstacles.push_back({.polygon = PolygonWithHoles{{{5, 0}, {6, 0}, {6, 4}, {5, 4}}, {}}});
  const FreeSpace space = BuildFreeSpace(world).value();
  const ContactMap map(space, 0.1);
  const auto track = [&](double cable_m, const Polyline& path, int max_steps = 500) {
    const auto env =
        TetherEnv::Create(map, {.laid = {{2, 2}}, .cable_length_m = cable_m, .goal = {9, 2}}, {.max_steps = max_steps});
    return TrackPath(env.value(), path).end;
  };
  EXPECT_EQ(track(30, {{2, 2}, {4, 4.8}, {7, 4.8}, {9, 2}}), TrackEnd::kAtGoal);
  EXPECT_EQ(track(30, {{2, 2}, {9, 2}}), TrackEnd::kHitObstacle);
  EXPECT_EQ(track(3, {{2, 2}, {4, 4.8}, {7, 4.8}, {9, 2}}), TrackEnd::kHeld);
  EXPECT_EQ(track(30, {{2, 2}, {4, 4.8}}), TrackEnd::kOffGoal);
  EXPECT_EQ(track(30, {{2, 2}, {4, 4.8}, {7, 4.8}, {9, 2}}, 20), TrackEnd::kCut);
}

}  // namespace
}  // namespace tautline
