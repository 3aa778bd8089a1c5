#include "tautline/planners/tether/tether_planner.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/homotopy/sketched_scene.h"
#include "tautline/planners/tether/random_tether.h"
#include "tautline/planners/tether/verify_plan.h"

namespace tautline {
namespace {

class TetherPlannerRandom : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Families, TetherPlannerRandom, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "Lattice" : "Separated"; });

/// Two answers to one question: the same but for the choice among motions of equal length.
void ExpectSame(const PlanResult& a, const PlanResult& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.obstruction, b.obstruction);
  EXPECT_EQ(a.start.points, b.start.points);
  ASSERT_EQ(a.motion.has_value(), b.motion.has_value());
  if (a.motion) {
    EXPECT_NEAR(a.motion->path.length, b.motion->path.length, 1e-9 * (1 + b.motion->path.length));
  }
  ASSERT_EQ(a.shortest_tether.has_value(), b.shortest_tether.has_value());
  if (a.shortest_tether) {
    EXPECT_NEAR(a.shortest_tether->length, b.shortest_tether->length, 1e-9 * (1 + b.shortest_tether->length));
  }
  EXPECT_EQ(a.rejected.has_value(), b.rejected.has_value());
}

TEST_P(TetherPlannerRandom, AnswersThePreparedQuestionsAlike) {
  int rejected = 0;
  const std::int64_t count = ScaledTestCount(300);
  for (std::int64_t seed = 0; seed < count; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomTether random = MakeRandomTether(rng, GetParam());
    const Scene scene = random.scene();
    const auto planner = TetherPlanner::Prepare(scene.world).value();
    const PlanResult expected = planner.Plan(*scene.tether, *scene.goal);
    const PlanResult from_start = planner.Plan(planner.PrepareStart(*scene.tether), *scene.goal);
    const PlanResult to_goal = planner.Plan(*scene.tether, planner.PrepareGoal(*scene.goal));
    ExpectSame(from_start, expected);
    ExpectSame(to_goal, expected);
    for (const PlanResult& result : {from_start, to_goal}) {
      const Verification verification = VerifyPlan(planner, *scene.tether, *scene.goal, result);
      EXPECT_TRUE(verification.ok()) << verification.faults[0];
    }
    ASSERT_FALSE(HasFailure());
    rejected += expected.rejected ? 1 : 0;
  }
  EXPECT_GT(rejected, count / 10);
}

/// One prepared map, eight threads.
TEST(TetherPlanner, AnswersSeveralThreads) {
  Rng rng(1);
  const RandomTether random = MakeRandomTether(rng, false);
  const Scene scene = random.scene();
  const auto planner = TetherPlanner::Prepare(scene.world).value();
  const PreparedStart start = planner.PrepareStart(*scene.tether);
  std::vector<Point> goals;
  for (int i = 0; i < 40; ++i) goals.push_back(RandomFreePoint(rng, random.ground));
  std::vector<PlanResult> expected;
  for (const Point goal : goals) expected.push_back(planner.Plan(*scene.tether, goal));
  std::vector<std::vector<PlanResult>> found(8);
  std::vector<std::thread> threads;
  for (auto& results : found) {
    threads.emplace_back([&] {
      for (const Point goal : goals) results.push_back(planner.Plan(start, goal));
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const auto& results : found) {
    for (std::size_t i = 0; i < goals.size(); ++i) ExpectSame(results[i], expected[i]);
  }
}

/// A grid of square pillars: n by n.
World Pillars(int n) {
  World world;
  const double size = 2.0 * n + 1;
  world.outline = Ring{{0, 0}, {size, 0}, {size, size}, {0, size}};
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const double x = 2 * i + 1, y = 2 * k + 1;
      Obstacle pillar;
      pillar.name = "p" + std::to_string(i) + "_" + std::to_string(k);
      pillar.polygon = PolygonWithHoles{Ring{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}, {}};
      world.obstacles.push_back(pillar);
    }
  }
  return world;
}

TEST(TetherPlanner, StopsWhereItsCallerSaysSo) {
  const auto planner = TetherPlanner::Prepare(Pillars(40)).value();
  const Tether tether{{0.5, 0.5}, 205, Polyline{{0.5, 0.5}, {0.5, 80.5}, {80.5, 80.5}, {80.5, 40.5}}};
  const PlanResult undisturbed = planner.Plan(tether, {40.5, 0.5});
  EXPECT_EQ(undisturbed.status, PlanStatus::kSolved);
  int asked = 0;
  const PlanResult stopped = planner.Plan(tether, {40.5, 0.5}, {.keep_going = [&asked] { return ++asked < 2; }});
  EXPECT_EQ(asked, 2);
  EXPECT_EQ(stopped.status, PlanStatus::kBudgetExceeded);
  EXPECT_FALSE(stopped.motion);
  EXPECT_FALSE(stopped.explanation.empty());
  const PlanResult listed =
      planner.Plan(tether, {40.5, 0.5}, {.all = true, .max_all = 1'000'000, .keep_going = [] { return false; }});
  EXPECT_FALSE(listed.all_complete);
  const auto never = std::chrono::steady_clock::now() - std::chrono::seconds(1);
  EXPECT_FALSE(Until(never)());
  EXPECT_TRUE(Until(std::chrono::steady_clock::now() + std::chrono::hours(1))());
}

TEST(TetherPlanner, TellsHowFarItsPreparationIsAndStops) {
  std::vector<double> shares;
  const auto planner = TetherPlanner::Prepare(Pillars(20), {.watch = [&](std::string_view, double share) {
                                                shares.push_back(share);
                                                return true;
                                              }});
  ASSERT_TRUE(planner);
  EXPECT_GT(shares.size(), 3U);
  for (const double share : shares) EXPECT_TRUE(share >= 0 && share <= 1);
  for (std::size_t stop = 0; stop < shares.size(); ++stop) {
    std::size_t told = 0;
    const auto stopped =
        TetherPlanner::Prepare(Pillars(20), {.watch = [&](std::string_view, double) { return told++ < stop; }});
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, ErrorCode::kStopped);
  }
}

/// Small triangles and quadrilaterals, one in each cell of an n by n grid.
World Specks(Rng& rng, int n) {
  World world;
  const double size = n;
  world.outline = Ring{{0, 0}, {size, 0}, {size, size}, {0, size}};
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const Point centre{i + rng.Uniform(0.3, 0.7), k + rng.Uniform(0.3, 0.7)};
      const int corners = rng.UniformInt(3, 4);
      Obstacle speck;
      speck.name = "s" + std::to_string(world.obstacles.size());
      speck.polygon.emplace();
      for (int c = 0; c < corners; ++c) {
        const double angle = 2 * M_PI * (c + rng.Uniform(0, 0.6)) / corners;
        speck.polygon->outer.push_back(centre + rng.Uniform(0.05, 0.28) * Point{std::cos(angle), std::sin(angle)});
      }
      world.obstacles.push_back(speck);
    }
  }
  return world;
}

/// A question among specks whose tether has little to spare, so that the classes that it allows can all be listed.
struct TightQuestion {
  Tether tether;
  Point goal;
};

std::optional<TightQuestion> MakeTightQuestion(Rng& rng, const TautSpace& space, double size) {
  const auto free_point = [&] {
    for (;;) {
      const Point p{rng.Uniform(0, size), rng.Uniform(0, size)};
      if (space.Locate(p)) return p;
    }
  };
  const Point base = free_point(), robot = free_point(), goal = free_point();
  const double slack = rng.Uniform(1.0, 1.02);
  const double to_goal = FindClasses(space, base, goal, {.max_count = 1}).classes.at(0).length;
  const ClassList cables =
      FindClasses(space, base, robot, {.max_length = slack * to_goal, .max_count = 300, .budget = 100'000});
  if (cables.classes.empty()) return std::nullopt;
  const TautPath& cable =
      cables.classes[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(cables.classes.size()) - 1))];
  return TightQuestion{{base, slack * to_goal, cable.points}, goal};
}

/// Among n by n specks the choice finds the best of all classes that the tether allows, and that with few labels.
void ExpectBestOfAllClasses(int n, std::int64_t count, int least_binding) {
  int listed = 0, binding = 0;
  for (std::int64_t seed = 0; seed < count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", specks " + std::to_string(n * n));
    Rng rng(static_cast<std::uint64_t>(seed));
    const World world = Specks(rng, n);
    const auto planner = TetherPlanner::Prepare(world).value();
    const auto question = MakeTightQuestion(rng, planner.space(), n);
    if (!question) continue;
    // Labels at most twice the directed edges: nothing explodes.
    const auto most = static_cast<std::int64_t>(2 * planner.space().graph().edges().size());
    const PlanResult best = planner.Plan(question->tether, question->goal, {.budget = most});
    ASSERT_EQ(best.status, PlanStatus::kSolved);
    const PlanResult all =
        planner.Plan(question->tether, question->goal, {.all = true, .max_all = 3000, .budget = 1'000'000});
    if (!all.all_complete) continue;
    ++listed;
    binding += best.rejected ? 1 : 0;
    ASSERT_NEAR(best.motion->path.length, all.all.at(0).path.length, 1e-9 * (1 + best.motion->path.length));
  }
  EXPECT_GT(listed, count / 4);
  EXPECT_GE(binding, least_binding);
}

TEST(TetherPlanner, FindsTheBestOfAllClassesAmongForty) {
  ExpectBestOfAllClasses(6, ScaledTestCount(200), ScaledTestCount(200) >= 100 ? 20 : 0);
}

TEST(TetherPlanner, NeitherBlowsUpNorLosesTheOptimumAmongHundreds) {
  ExpectBestOfAllClasses(18, ScaledTestCount(60), ScaledTestCount(60) >= 30 ? 4 : 0);
}

}  // namespace
}  // namespace tautline
