#include "tautline/planners/contact_free/tether_env.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"

namespace tautline {
namespace {

Ring Rectangle(double x, double y, double w, double h) { return {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}; }

/// A room of 12 m x 12 m with rectangles in it.
struct Room {
  World world{.outline = Rectangle(0, 0, 12, 12)};
  FreeSpace space;
  std::optional<ContactMap> map;

  explicit Room(const std::vector<Ring>& rectangles = {}) {
    for (const Ring& ring : rectangles) world.obstacles.push_back({.polygon = PolygonWithHoles{ring, {}}});
    space = BuildFreeSpace(world).value();
    map.emplace(space, 0.125);
  }
};

TetherEnv MakeEnv(const Room& room, const TetherTask& task, const TetherEnvOptions& options = {}) {
  auto env = TetherEnv::Create(*room.map, task, options);
  EXPECT_TRUE(env) << ToString(env.error());
  return *std::move(env);
}

TEST(TetherEnv, DrivesStraightToTheGoal) {
  const Room room;
  TetherEnv env =
      MakeEnv(room, {.laid = {{2, 6}}, .cable_length_m = 9, .goal = {5, 6}, .waypoints = {{2.5, 6}, {3, 6}, {5, 6}}});
  double sum = 0;
  EnvStep step;
  for (int i = 0; i < 100 && !step.ends(); ++i) {
    step = env.Step(TetherAction::kStraight);
    sum += step.reward;
    EXPECT_FALSE(step.cable_robot) << i;
    EXPECT_FALSE(step.cable_obstacle);
  }
  EXPECT_TRUE(step.at_goal);
  EXPECT_EQ(env.steps(), 25);
  // The goal, three way-points, 25 steps; between the second and the third way-point the robot is never 1.25 m off.
  EXPECT_NEAR(sum, 50 + 50 - 25 * 0.001, 1e-9);
  EXPECT_NEAR(env.cable().paid_out_m(), 2, 1e-9);
}

TEST(TetherEnv, LeavesItsBaseInAnyDirectionWithoutStandingOnItsCable) {
  const Room room;
  for (int degrees = 0; degrees < 360; ++degrees) {
    TetherEnv env = MakeEnv(
        room,
        {.laid = {{6.3, 6.1}}, .heading_rad = degrees * std::numbers::pi / 180, .cable_length_m = 9, .goal = {10, 10}});
    for (int i = 0; i < 10; ++i) EXPECT_FALSE(env.Step(TetherAction::kStraight).cable_robot) << degrees << ", " << i;
  }
}

TEST(TetherEnv, TurnsOnTheSpotAndDragsItsTail) {
  const Room room;
  TetherEnv env = MakeEnv(room, {.laid = {{2, 6}}, .heading_rad = 0, .cable_length_m = 9, .goal = {10, 10}});
  const EnvStep left = env.Step(TetherAction::kLeft);
  EXPECT_NEAR(left.reward, -0.101, 1e-12);
  EXPECT_NEAR(env.pose().heading_rad, 0.2, 1e-12);
  EXPECT_NEAR(env.cable().tail().y, 6 - 0.5 * std::sin(0.2), 1e-12);
  env.Step(TetherAction::kRight);
  EXPECT_NEAR(env.pose().heading_rad, 0, 1e-12);
}

TEST(TetherEnv, EndsAtAWall) {
  const Room room;
  TetherEnv env = MakeEnv(room, {.laid = {{10, 6}}, .cable_length_m = 9, .goal = {11.9, 11}});
  env.Step(TetherAction::kRight);
  EnvStep step;
  while (!step.ends()) step = env.Step(TetherAction::kStraight);
  EXPECT_TRUE(step.robot_obstacle);
  EXPECT_NEAR(step.reward, -1.001, 1e-12);
  EXPECT_LT(env.pose().at.x, 11.5);
  EXPECT_GT(env.pose().at.x, 11.39);
}

TEST(TetherEnv, ATautCableHoldsTheRobot) {
  const Room room;
  TetherEnv env = MakeEnv(room, {.laid = {{2, 6}}, .cable_length_m = 3, .goal = {9, 6}});
  EnvStep step;
  while (!step.ends()) step = env.Step(TetherAction::kStraight);
  EXPECT_TRUE(step.cut);
  EXPECT_TRUE(step.held);
  EXPECT_FALSE(step.at_goal);
  EXPECT_NEAR(env.pose().at.x, 5.5, 0.1 + 1e-9);
  EXPECT_EQ(env.steps(), 500);
}

TEST(TetherEnv, CountsItsCableUnderTheRobot) {
  const Room room;
  TetherEnv env = MakeEnv(room, {.laid = {{2, 6}, {8, 6}}, .cable_length_m = 9, .goal = {2, 11}});
  int on_cable = 0;
  for (int i = 0; i < 16; ++i) on_cable += env.Step(TetherAction::kLeft).cable_robot ? 1 : 0;
  for (int i = 0; i < 20; ++i) on_cable += env.Step(TetherAction::kStraight).cable_robot ? 1 : 0;
  EXPECT_GT(on_cable, 5);
}

TEST(TetherEnv, CountsACableAtAnObstacleOnceAStep) {
  const Room room({Rectangle(4, 5.9, 1, 0.2), Rectangle(6, 5.9, 1, 0.2)});
  TetherEnv env = MakeEnv(room, {.laid = {{2, 6}, {9, 6}}, .cable_length_m = 9, .goal = {2, 11}});
  const EnvStep step = env.Step(TetherAction::kStraight);
  EXPECT_TRUE(step.cable_obstacle);
  EXPECT_NEAR(step.reward, -1.001, 1e-12);
}

TEST(TetherEnv, ABaseInAWallIsASocket) {
  const Room room;
  TetherEnv env = MakeEnv(room, {.laid = {{0, 6}, {4, 6}}, .cable_length_m = 9, .goal = {2, 11}});
  EXPECT_FALSE(env.Step(TetherAction::kStraight).cable_obstacle);
}

TEST(TetherEnv, ObservationsAreRoundedThePoseIsNot) {
  const Room room;
  const TetherTask task{.laid = {{2.04, 6}}, .heading_rad = 0.1, .cable_length_m = 9, .goal = {9, 6}};
  const TetherEnv metres = MakeEnv(room, task, {.observation = ObservationScale::kMetres});
  EXPECT_FLOAT_EQ(metres.Observe()[0], 2.0F);
  EXPECT_FLOAT_EQ(metres.Observe()[2], static_cast<float>(std::numbers::pi / 18));
  EXPECT_EQ(metres.pose().at.x, 2.04);
  const TetherEnv scaled = MakeEnv(room, task);
  EXPECT_FLOAT_EQ(scaled.Observe()[0], (2.0F - 6) / 6);
  EXPECT_FLOAT_EQ(scaled.Observe()[1], 0);
  EXPECT_FLOAT_EQ(scaled.Observe()[2], 1.0F / 18);
}

TEST(TetherEnv, TheSeedMovesTheStartWhereAskedTo) {
  const Room room({Rectangle(4, 4, 1, 1)});
  const TetherTask task{.laid = {{3.4, 4.5}}, .cable_length_m = 9, .goal = {9, 6}};
  TetherEnv still = MakeEnv(room, task);
  still.Reset(7);
  EXPECT_EQ(still.pose().at, (Point{3.4, 4.5}));
  TetherEnv noisy = MakeEnv(room, task, {.start_noise_m = 0.5, .heading_noise_rad = 1});
  noisy.Reset(7);
  const RobotPose first = noisy.pose();
  EXPECT_NE(first.at, (Point{3.4, 4.5}));
  noisy.Reset(8);
  EXPECT_NE(first.at, noisy.pose().at);
  noisy.Reset(7);
  EXPECT_EQ(first.at, noisy.pose().at);
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    noisy.Reset(seed);
    EXPECT_FALSE(room.map->DiscTouches(noisy.pose().at, 0.5));
  }
}

TEST(TetherEnv, SaysWhatIsWrongWithATask) {
  const Room room({Rectangle(4, 4, 1, 1)});
  const auto fault = [&](const TetherTask& task, const TetherEnvOptions& options = {}) {
    const auto env = TetherEnv::Create(*room.map, task, options);
    return env ? std::string("none") : env.error().message;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const TetherTask good{.laid = {{2, 6}}, .cable_length_m = 9, .goal = {9, 6}};
  EXPECT_EQ(fault(good), "none");
  TetherTask bad = good;
  bad.cable_length_m = 0;
  EXPECT_NE(fault(bad).find("at least"), std::string::npos);
  bad = good;
  bad.laid = {{2, 6}, {4.5, 3.6}};
  EXPECT_NE(fault(bad).find("disc"), std::string::npos);
  bad = good;
  bad.goal = {4.5, 4.5};
  EXPECT_NE(fault(bad).find("goal"), std::string::npos);
  bad = good;
  bad.goal.x = nan;
  EXPECT_NE(fault(bad), "none");
  for (const TetherEnvOptions& options :
       {TetherEnvOptions{.robot_radius_m = 0}, TetherEnvOptions{.link_length_m = nan}, TetherEnvOptions{.dt_s = -1},
        TetherEnvOptions{.turn_rad_per_s = 400}, TetherEnvOptions{.max_steps = 0}, TetherEnvOptions{.grid_m = 0},
        TetherEnvOptions{.grid_m = 1e-320}, TetherEnvOptions{.start_noise_m = 1e300},
        TetherEnvOptions{.heading_noise_rad = 1e300}, TetherEnvOptions{.reward = {.goal = nan}},
        TetherEnvOptions{.reward = {.deviation_from_radii = nan}}}) {
    EXPECT_NE(fault(good, options), "none");
  }
}

TEST(TetherEnv, TheCableNeedsToReachTheTailAndNoMore) {
  const Room room;
  const auto can = [&](double heading_rad, double length_m) {
    const TetherTask task{
        .laid = {{2, 6}, {5, 6}}, .heading_rad = heading_rad, .cable_length_m = length_m, .goal = {9, 6}};
    return TetherEnv::Create(*room.map, task, {}).has_value();
  };
  EXPECT_TRUE(can(0, 2.5));
  // As long up to rounding, as sums of many segments are.
  EXPECT_TRUE(can(0, 2.5 * (1 - 1e-12)));
  EXPECT_FALSE(can(0, 2.499));
  // Looking back, the tail is half a metre beyond the robot's centre.
  EXPECT_FALSE(can(std::numbers::pi, 3.4));
  EXPECT_TRUE(can(std::numbers::pi, 3.5));
}

TEST(TetherEnv, AnyFiniteTurnIsATurn) {
  const Room room;
  TetherEnv env = MakeEnv(room, {.laid = {{2, 6}}, .heading_rad = 0, .cable_length_m = 9, .goal = {10, 10}});
  for (const double turn : {70.0, -400.0, 1e12, -1e300}) {
    const double before = env.pose().heading_rad;
    env.StepWith(0, turn);
    const double heading = env.pose().heading_rad;
    EXPECT_LE(std::abs(heading), std::numbers::pi);
    if (std::abs(turn) > 1000) continue;  // A double does not say where in its turn that is.
    EXPECT_NEAR(std::sin(heading), std::sin(before + turn * 0.1), 1e-9) << turn;
    EXPECT_NEAR(std::cos(heading), std::cos(before + turn * 0.1), 1e-9) << turn;
  }
}

TEST(TetherEnv, AStartMayLookAnywhere) {
  const Room room;
  TetherEnv env = MakeEnv(room, {.laid = {{6, 6}}, .cable_length_m = 9, .goal = {10, 10}}, {.heading_noise_rad = 1e12});
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    env.Reset(seed);
    EXPECT_LE(std::abs(env.pose().heading_rad), std::numbers::pi);
  }
}

/// The equations of the paper and the notes of the README, one after the other, without any care for time.
struct SlowEnv {
  static constexpr double kRadius = 0.2;

  std::vector<Box> boxes;
  TetherTask task;
  RobotPose pose;
  CableChain chain;
  std::vector<bool> passed;

  static bool Meets(Point a, Point b, const Box& box) {
    // Eq. 8: the parameters at which the segment enters and leaves the two slabs.
    double enter = 0, leave = 1;
    for (const bool x : {true, false}) {
      const double from = x ? a.x : a.y, by = x ? b.x - a.x : b.y - a.y;
      const double low = x ? box.low.x : box.low.y, high = x ? box.high.x : box.high.y;
      if (by == 0) {
        if (from < low || from > high) return false;
        continue;
      }
      enter = std::max(enter, std::min((low - from) / by, (high - from) / by));
      leave = std::min(leave, std::max((low - from) / by, (high - from) / by));
    }
    return enter <= leave;
  }
  static double DistanceToBox(Point p, const Box& box) {
    const double dx = std::max({box.low.x - p.x, 0.0, p.x - box.high.x});
    const double dy = std::max({box.low.y - p.y, 0.0, p.y - box.high.y});
    return std::sqrt(dx * dx + dy * dy);
  }
  bool Hits(Point p) const {
    bool hits = p.x <= kRadius || p.y <= kRadius || p.x >= 12 - kRadius || p.y >= 12 - kRadius;
    for (const Box& box : boxes) hits = hits || DistanceToBox(p, box) <= kRadius;
    return hits;
  }
  EnvStep Step(double v, double w) {
    EnvStep step;
    step.reward = -0.001 + (v == 0 && w != 0 ? -0.1 : 0);
    const RobotPose to{
        {pose.at.x + v * std::cos(pose.heading_rad) * 0.1, pose.at.y + v * std::sin(pose.heading_rad) * 0.1},
        std::remainder(pose.heading_rad + w * 0.1, 2 * std::numbers::pi)};
    step.robot_obstacle = Hits(to.at);
    if (step.robot_obstacle) {
      step.reward -= 1;
    } else if (chain.Pull(to.at - kRadius * Point{std::cos(to.heading_rad), std::sin(to.heading_rad)})) {
      pose = to;
    } else {
      step.held = true;
    }
    const auto x = chain.nodes();
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
      for (const Box& box : boxes) step.cable_obstacle = step.cable_obstacle || Meets(x[i], x[i + 1], box);
      for (const Point p : {x[i], x[i + 1]}) {
        step.cable_obstacle = step.cable_obstacle || p.x <= 0 || p.y <= 0 || p.x >= 12 || p.y >= 12;
      }
      // Links longer than the radius: of all nodes, only the base can be too near along the cable.
      const bool near_tail = i == 0 && chain.paid_out_m() <= kRadius * (1 + 1e-9);
      step.cable_robot = step.cable_robot || (!near_tail && Distance(x[i], pose.at) <= kRadius);
    }
    step.at_goal = !step.robot_obstacle && Distance(pose.at, task.goal) <= 0.5;
    step.reward += (step.cable_obstacle ? -1 : 0) + (step.cable_robot ? -0.5 : 0) + (step.at_goal ? 50 : 0);
    double nearest = 1e300;
    for (std::size_t i = 0; i < passed.size(); ++i) {
      const double distance = Distance(task.waypoints[i], pose.at);
      nearest = std::min(nearest, distance);
      if (distance <= kRadius && !passed[i]) {
        passed[i] = true;
        step.reward += 50.0 / static_cast<double>(passed.size());
      }
    }
    if (nearest > 2.5 * kRadius) step.reward -= nearest - 2.5 * kRadius;
    return step;
  }
};

TEST(TetherEnvRandom, AgreesWithTheEquationsWrittenOut) {
  const auto walks = ScaledTestCount(300);
  int touched = 0, stood = 0, hit = 0, held = 0;
  for (int seed = 1; seed <= walks; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    std::vector<Ring> rectangles;
    for (int i = rng.UniformInt(0, 6); i > 0; --i) {
      // On a lattice of their own columns and rows, so that none merge.
      rectangles.push_back(Rectangle(1 + 2 * (i % 6) + rng.Uniform(0, 0.5), rng.Uniform(1, 9), rng.Uniform(0.2, 1.4),
                                     rng.Uniform(0.2, 1.4)));
    }
    const Room room(rectangles);
    const TetherTask task{.laid = {{rng.Uniform(1, 11), rng.Uniform(1, 11)}},
                          .heading_rad = rng.Uniform(-3, 3),
                          .cable_length_m = rng.Uniform(2, 14),
                          .goal = {rng.Uniform(1, 11), rng.Uniform(1, 11)},
                          .waypoints = {{rng.Uniform(1, 11), 3}, {5, rng.Uniform(1, 11)}, {6, 6}}};
    auto env = TetherEnv::Create(*room.map, task, {.robot_radius_m = SlowEnv::kRadius});
    if (!env) continue;
    SlowEnv slow{.boxes = {},
                 .task = task,
                 .pose = env->pose(),
                 .chain = env->cable(),
                 .passed = std::vector<bool>(task.waypoints.size())};
    for (const Ring& ring : rectangles) slow.boxes.push_back(BoundingBox(ring));
    EnvStep step;
    double w = 0, v = 1;
    while (!step.ends()) {
      if (rng.UniformInt(0, 9) == 0) w = rng.Uniform(-2, 2), v = rng.UniformInt(0, 4) == 0 ? 0 : 1;
      step = env->StepWith(v, w);
      const EnvStep expected = slow.Step(v, w);
      ASSERT_NEAR(step.reward, expected.reward, 1e-9);
      ASSERT_EQ(step.cable_obstacle, expected.cable_obstacle);
      ASSERT_EQ(step.cable_robot, expected.cable_robot);
      ASSERT_EQ(step.robot_obstacle, expected.robot_obstacle);
      ASSERT_EQ(step.at_goal, expected.at_goal);
      ASSERT_EQ(step.held, expected.held);
      touched += step.cable_obstacle ? 1 : 0;
      stood += step.cable_robot ? 1 : 0;
      held += step.held ? 1 : 0;
      hit += step.robot_obstacle ? 1 : 0;
    }
  }
  EXPECT_GE(touched, walks / 30);
  EXPECT_GE(stood, walks / 30);
  EXPECT_GE(hit, walks / 30);
  EXPECT_GE(held, walks / 100);
}

}  // namespace
}  // namespace tautline
