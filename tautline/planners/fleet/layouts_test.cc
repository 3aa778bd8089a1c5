#include "tautline/planners/fleet/layouts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tautline/base/test_scale.h"
#include "tautline/planners/fleet/check_layout.h"
#include "tautline/planners/fleet/random_fleet.h"
#include "tautline/scene/scene_file.h"

namespace tautline {
namespace {

FleetGround Prepared(const Scene& scene) {
  auto ground = FleetGround::Prepare(scene);
  EXPECT_TRUE(ground) << ground.error().message;
  return *std::move(ground);
}

/// All sequences of distinct nodes, each tried as a line, and all layouts of them, each checked as a whole.
class ProductOracle {
 public:
  explicit ProductOracle(const FleetGround& ground) : ground_(ground), lines_(ground.size()) {
    for (std::size_t i = 0; i < ground.size(); ++i) {
      std::vector<FleetNodeId> nodes;
      AddLines(RobotId(i), nodes);
    }
  }

  /// The total lengths of all layouts, sorted.
  std::vector<double> Totals(double max_length = 1e300) {
    totals_.clear();
    layout_.clear();
    Combine(max_length);
    std::sort(totals_.begin(), totals_.end());
    return totals_;
  }

 private:
  void AddLines(RobotId robot, std::vector<FleetNodeId>& nodes) {
    TryLine(robot, nodes);
    for (std::size_t k = ground_.size(); k < ground_.node_count(); ++k) {
      const FleetNodeId node(k);
      if (node == ground_.target(robot) || std::find(nodes.begin(), nodes.end(), node) != nodes.end()) continue;
      nodes.push_back(node);
      AddLines(robot, nodes);
      nodes.pop_back();
    }
  }

  void TryLine(RobotId robot, const std::vector<FleetNodeId>& nodes) {
    Polyline line{ground_.robot(robot).start};
    for (const FleetNodeId node : nodes) line.push_back(ground_.point(node));
    line.push_back(ground_.robot(robot).target);
    const auto route = ReadRoute(ground_, robot, line);
    if (!route || !SelfLoops(ground_, robot, *route).empty() || !EnclosedStarts(ground_, robot, *route).empty()) return;
    const auto& tether = ground_.robot(robot).tether;
    if (tether && LengthOf(ground_, *route) > *tether) return;
    for (std::size_t k = 1; k + 1 < route->size(); ++k) {
      if ((*route)[k].side == Side::kNone) return;
    }
    auto& lines = lines_[robot.index()];
    if (std::find(lines.begin(), lines.end(), *route) == lines.end()) lines.push_back(*route);
  }

  void Combine(double max_length) {
    if (layout_.size() == ground_.size()) {
      if (!CheckLayout(ground_, layout_).none()) return;
      double total = 0;
      for (const Route& route : layout_) total += LengthOf(ground_, route);
      totals_.push_back(total);
      return;
    }
    for (const Route& line : lines_[layout_.size()]) {
      if (LengthOf(ground_, line) > max_length) continue;
      layout_.push_back(line);
      Combine(max_length);
      layout_.pop_back();
    }
  }

  const FleetGround& ground_;
  std::vector<std::vector<Route>> lines_;
  FleetLayout layout_;
  std::vector<double> totals_;
};

void ExpectTotals(const std::vector<double>& expected, const LayoutsResult& found) {
  ASSERT_EQ(found.layouts.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(found.layouts[k].total, expected[k], 1e-9);
}

void Compare(const FleetGround& ground, std::size_t& layouts) {
  ProductOracle oracle(ground);
  const std::vector<double> all = oracle.Totals();
  layouts += all.size();
  const LayoutsResult found = FindLayouts(ground, {.max_count = 100'000, .count_all = true});
  ExpectTotals(all, found);
  EXPECT_TRUE(found.complete);
  EXPECT_EQ(found.count, all.size());
  for (const FoundLayout& layout : found.layouts) EXPECT_TRUE(CheckLayout(ground, layout.routes).none());
  if (all.size() < 3) return;
  const LayoutsResult some = FindLayouts(ground, {.max_count = all.size() / 2});
  ExpectTotals({all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2)}, some);
  EXPECT_FALSE(some.complete);
  const double middle = all[all.size() / 2] + 1e-6;
  const auto below = std::partition_point(all.begin(), all.end(), [&](double total) { return total <= middle; });
  const LayoutsResult short_ones = FindLayouts(ground, {.max_total = middle, .max_count = 100'000, .count_all = true});
  ExpectTotals({all.begin(), below}, short_ones);
  EXPECT_TRUE(short_ones.complete);
  const double longest = *std::max_element(found.layouts[0].lengths.begin(), found.layouts[0].lengths.end()) + 1e-6;
  ExpectTotals(oracle.Totals(longest), FindLayouts(ground, {.max_length = longest, .max_count = 100'000}));
}

TEST(FindLayouts, AgreesWithTheProductOfAllLines) {
  constexpr std::uint64_t kSeed = 5;
  Rng rng(kSeed);
  SCOPED_TRACE(kSeed);
  const std::int64_t count = ScaledTestCount(150);
  std::size_t layouts = 0;
  for (std::int64_t trial = 0; trial < count && !testing::Test::HasFailure(); ++trial) {
    const bool on_lattice = trial % 3 == 0;
    Compare(Prepared(RandomFleet(rng, rng.UniformInt(1, 4), on_lattice ? 6 : 10, on_lattice)), layouts);
  }
  EXPECT_GT(layouts, static_cast<std::size_t>(count));
}

TEST(FindLayouts, AgreesWithTheProductAmongObstacles) {
  constexpr std::uint64_t kSeed = 6;
  Rng rng(kSeed);
  SCOPED_TRACE(kSeed);
  const std::int64_t count = ScaledTestCount(60);
  std::size_t layouts = 0;
  for (std::int64_t trial = 0; trial < count && !testing::Test::HasFailure(); ++trial) {
    Scene scene = RandomFleet(rng, rng.UniformInt(1, 3), 10, false);
    scene.world.outline = {{-1, -1}, {11, -1}, {11, 11}, {-1, 11}};
    Obstacle wedge;
    wedge.name = "wedge";
    wedge.polygon = PolygonWithHoles{.outer = {{3, 4}, {7, 4.5}, {5, rng.Uniform(5, 8)}}, .holes = {}};
    scene.world.obstacles.push_back(wedge);
    Compare(Prepared(scene), layouts);
  }
  EXPECT_GT(layouts, static_cast<std::size_t>(count));
}

TEST(FindLayouts, MirroredScenesHaveMirroredLayouts) {
  Rng rng(7);
  for (std::int64_t trial = ScaledTestCount(40); trial > 0; --trial) {
    Scene scene = RandomFleet(rng, 5, 10, false);
    const LayoutsResult found = FindLayouts(Prepared(scene), {.count_all = true});
    for (FleetRobot& robot : scene.fleet->robots) {
      robot.start.x = -robot.start.x;
      robot.target.x = -robot.target.x;
    }
    const LayoutsResult mirrored = FindLayouts(Prepared(scene), {.count_all = true});
    EXPECT_EQ(found.count, mirrored.count);
    ASSERT_EQ(found.layouts.size(), mirrored.layouts.size());
    for (std::size_t k = 0; k < found.layouts.size(); ++k) {
      EXPECT_NEAR(found.layouts[k].total, mirrored.layouts[k].total, 1e-9);
    }
  }
}

TEST(FindLayouts, KnowsAllOfTheThreeRobots) {
  auto scene = ReadSceneFile("scenes/fleet.yaml");
  ASSERT_TRUE(scene) << scene.error().message;
  const FleetGround ground = Prepared(*scene);
  const LayoutsResult found = FindLayouts(ground);
  EXPECT_EQ(found.layouts.size(), 8u);
  EXPECT_TRUE(found.complete);
  EXPECT_EQ(found.layouts[0].routes, *ReadLayout(ground));
}

TEST(FindLayouts, TellsWhoHasNoCableLine) {
  Rng rng(8);
  Scene scene = RandomFleet(rng, 3, 10, false);
  scene.fleet->robots[1].tether = 0.5 * Distance(scene.fleet->robots[1].start, scene.fleet->robots[1].target);
  const LayoutsResult found = FindLayouts(Prepared(scene));
  EXPECT_TRUE(found.layouts.empty());
  EXPECT_TRUE(found.complete);
  EXPECT_EQ(found.without_route, std::vector{RobotId(std::size_t{1})});
}

TEST(FindLayouts, StopsWhenToldSoOrOutOfBudget) {
  Rng rng(9);
  const FleetGround ground = Prepared(RandomFleet(rng, 9, 20, false));
  const LayoutsResult stopped = FindLayouts(ground, {.watch = [](std::string_view, double) { return false; }});
  EXPECT_TRUE(stopped.budget_exceeded);
  const LayoutsResult poor = FindLayouts(ground, {.budget = 50});
  EXPECT_TRUE(poor.budget_exceeded);
  EXPECT_FALSE(poor.complete);
}

}  // namespace
}  // namespace tautline
