#include "tautline/planners/contact_free/imitation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tautline/base/test_scale.h"
#include "tautline/network/onnx_file.h"
#include "tautline/planners/contact_free/random_course.h"

namespace tautline {
namespace {

/// The scene in a mirror along the x axis.
Scene MirrorImage(Scene scene) {
  const auto flip = [](Point& p) { p.y = -p.y; };
  for (Point& p : scene.world.outline) flip(p);
  for (Obstacle& obstacle : scene.world.obstacles) {
    for (Point& p : obstacle.polygon->outer) flip(p);
  }
  flip(scene.tether->base);
  flip(*scene.goal);
  return scene;
}

TEST(RandomCourseRandom, LeavesRoomForTheRobot) {
  const auto courses = ScaledTestCount(200);
  for (std::int64_t seed = 1; seed <= courses; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const Scene scene = RandomCourse(rng);
    const auto space = BuildFreeSpace(scene.world);
    ASSERT_TRUE(space);
    const ContactMap map(*space, 0.1);
    EXPECT_FALSE(map.DiscTouches(scene.tether->base, 0.5));
    EXPECT_FALSE(map.DiscTouches(*scene.goal, 0.5));
    EXPECT_GE(Distance(scene.tether->base, *scene.goal), 6);
  }
}

TEST(DriverViewRandom, InAMirrorIsTheMirroredView) {
  const auto courses = ScaledTestCount(40);
  int seen = 0;
  for (std::int64_t seed = 1; seed <= courses; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const Scene scene = RandomCourse(rng);
    auto course = MakeCourse(scene, {}), mirrored = MakeCourse(MirrorImage(scene), {});
    if (!course || !mirrored) continue;
    std::size_t waypoint = 0, mirrored_waypoint = 0;
    for (int step = 0; step < 60; ++step) {
      const double turn = rng.Uniform(-1, 1);
      const EnvStep here = course->env.StepWith(1, turn), there = mirrored->env.StepWith(1, -turn);
      ASSERT_EQ(here.ends(), there.ends());
      if (here.ends()) break;
      waypoint = AdvanceAlong(course->env, waypoint);
      mirrored_waypoint = AdvanceAlong(mirrored->env, mirrored_waypoint);
      const DriverView view = Mirrored(LookAround(course->env, waypoint));
      const DriverView other = LookAround(mirrored->env, mirrored_waypoint);
      int differ = 0;
      for (std::size_t i = 0; i < view.size(); ++i) {
        ASSERT_LE(std::abs(view[i]), 1.0F);
        // Cells of the map, and rays that a node lies between, are not the same in a mirror.
        differ += std::abs(view[i] - other[i]) > 0.05F ? 1 : 0;
      }
      EXPECT_LE(differ, 8);
      ++seen;
    }
  }
  EXPECT_GT(seen, 10 * courses);
}

TEST(DriverView, EndsAtCellsThatAreAllButBlocked) {
  // The wall keeps so far from the middle of a column of cells that a millionth of a millionth of a metre is free
  // there.
  const double cell = 0.125, half_diagonal = cell * std::sqrt(0.5), middle = 6.5 * cell;
  const double wall = middle + ((1 + 1e-6) * half_diagonal + 1e-12) / (1 - 1e-6);
  const FreeSpace space = BuildFreeSpace({.outline = Ring{{0, 0}, {wall, 0}, {wall, 2}, {0, 2}}}).value();
  const ContactMap map(space, cell);
  ASSERT_GT(map.ClearAround({middle, 1.05}), 0);
  ASSERT_LT(map.ClearAround({middle, 1.05}), 1e-11);
  const auto env = TetherEnv::Create(
      map, {.laid = {{0.4, 1.05}}, .heading_rad = 0, .cable_length_m = 2, .goal = {0.4, 1.6}}, {.robot_radius_m = 0.1});
  ASSERT_TRUE(env);
  const DriverView view = LookAround(*env, 0);
  EXPECT_NEAR(view[0], wall - 0.4, cell);
}

TEST(DriverView, MirroredTwiceIsTheSame) {
  DriverView view;
  for (std::size_t i = 0; i < view.size(); ++i) view[i] = static_cast<float>(i) / 100;
  EXPECT_NE(Mirrored(view), view);
  EXPECT_EQ(Mirrored(Mirrored(view)), view);
  const DriverIntent intent{0.1F, 0.2F, 0.3F, 0.4F};
  EXPECT_EQ(Mirrored(Mirrored(intent)), intent);
}

TEST(DriverIntent, IsTwoPointsOfTheWayInTheRobotsFrame) {
  const std::vector<Point> way = {{1, 1}, {1, 4}};
  // The robot looks along the way: 0.75 m and 2 m ahead, in units of 2 m.
  const DriverIntent ahead = IntentOf({{1, 1}, std::acos(-1.0) / 2}, way, 0.5);
  EXPECT_NEAR(ahead[0], 0.375, 1e-6);
  EXPECT_NEAR(ahead[1], 0, 1e-6);
  EXPECT_NEAR(ahead[2], 1, 1e-6);
  // East of it the way is to the left.
  const DriverIntent left = IntentOf({{1, 1}, 0}, way, 0.5);
  EXPECT_NEAR(left[0], 0, 1e-6);
  EXPECT_NEAR(left[1], 0.375, 1e-6);
  // A way that ends before is taken as far as it goes.
  EXPECT_NEAR(IntentOf({{1, 1}, 0}, std::vector<Point>{{1.5, 1}}, 0.5)[2], 0.25, 1e-6);
}

TEST(Imitate, LearnsWhatItSeesToTheSameBytes) {
  Demonstrations lessons;
  Rng rng(3);
  for (int k = 0; k < 400; ++k) {
    for (int i = 0; i < kViewSize; ++i) lessons.views.push_back(static_cast<float>(rng.Uniform(-1, 1)));
    // The first ray, which is on the axis of the mirror.
    const float first = lessons.views[lessons.views.size() - kViewSize];
    for (const float want : {0.5F * first, 0.0F, first, 0.0F}) lessons.intents.push_back(want);
  }
  std::vector<double> losses;
  const ImitationOptions options{
      .hidden = {32}, .epochs = 20, .batch = 32, .seed = 5, .progress = [&](int, double loss) {
        losses.push_back(loss);
        return true;
      }};
  const Mlp network = Imitate(lessons, options, PortableKernels());
  ASSERT_EQ(losses.size(), 20);
  EXPECT_LT(losses.back(), 0.5 * losses.front());
  const Mlp again = Imitate(lessons, options, PortableKernels());
  EXPECT_TRUE(std::equal(network.parameters().begin(), network.parameters().end(), again.parameters().begin()));
}

TEST(DriverPolicy, EvenWithoutKnowledgeItComesToTheGoalOrHitsNothing) {
  const Mlp nothing({kViewSize, 8, kIntentSize});
  const auto seeds = ScaledTestCount(20);
  int driven = 0;
  for (std::int64_t seed = 2; seed <= 2 * seeds; seed += 2) {
    SCOPED_TRACE(seed);
    const auto course = CourseOf(static_cast<std::uint64_t>(seed), {});
    if (!course) continue;
    const DrivenMotion motion = DriverPolicy(nothing, PortableKernels()).Drive(course->env);
    ASSERT_FALSE(motion.outcomes.empty());
    EXPECT_FALSE(motion.outcomes.back().robot_obstacle);
    ++driven;
  }
  EXPECT_GT(driven, 0);
}

TEST(DriverPolicy, WithoutNumbersItFollowsTheReference) {
  Mlp nonsense({kViewSize, 8, kIntentSize});
  for (float& parameter : nonsense.parameters()) parameter = std::numeric_limits<float>::quiet_NaN();
  const auto course = CourseOf(2, {});
  ASSERT_TRUE(course);
  for (const int look_ahead : {0, 40}) {
    DriverPolicy policy(nonsense, PortableKernels(), {.look_ahead_steps = look_ahead});
    const DrivenMotion motion = policy.Drive(course->env);
    ASSERT_FALSE(motion.velocities.empty());
    for (const Velocity& velocity : motion.velocities) {
      ASSERT_TRUE(std::isfinite(velocity.speed_m_per_s) && std::isfinite(velocity.turn_rad_per_s));
    }
  }
}

TEST(DriverPolicy, RefusesOtherNetworks) {
  Rng rng(1);
  const std::string other = WriteOnnx({Mlp::Random({3, 8, 3}, rng), {}});
  const auto policy = DriverPolicy::Read(other, "other.onnx", PortableKernels());
  ASSERT_FALSE(policy);
  EXPECT_NE(policy.error().message.find("no policy for all maps"), std::string::npos);
  EXPECT_FALSE(DriverPolicy::Read("", "empty.onnx", PortableKernels()));
  const std::string fits = WriteOnnx({Mlp::Random({kViewSize, 8, kIntentSize}, rng), {}});
  EXPECT_TRUE(DriverPolicy::Read(fits, "fits.onnx", PortableKernels()));
}

TEST(CollectDemonstrations, AreTheSameForTheSameSeed) {
  Demonstrations first, second;
  for (std::uint64_t seed = 2; first.size() == 0 && seed < 40; seed += 2) {
    first = CollectDemonstrations(seed, {});
    second = CollectDemonstrations(seed, {});
  }
  ASSERT_GT(first.size(), 0);
  EXPECT_EQ(first.views, second.views);
  EXPECT_EQ(first.intents, second.intents);
  for (const float value : first.intents) EXPECT_LE(std::abs(value), 1.01F);
}

}  // namespace
}  // namespace tautline
