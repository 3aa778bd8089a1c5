// Plans for random fleets against brute force: every order of passing at every crossing, played.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <utility>

#include "tautline/base/test_scale.h"
#include "tautline/geometry/predicates.h"
#include "tautline/planners/fleet/check_layout.h"
#include "tautline/planners/fleet/layouts.h"
#include "tautline/planners/fleet/plan_fleet.h"
#include "tautline/planners/fleet/playback.h"
#include "tautline/planners/fleet/random_fleet.h"
#include "tautline/planners/fleet/robot_paths.h"

namespace tautline {
namespace {

constexpr FleetMode kModes[] = {FleetMode::kStraightConcurrent, FleetMode::kStraightSequential,
                                FleetMode::kBentConcurrent, FleetMode::kBentSequential};

/// A crossing of two shortest paths, found without any index.
struct PlainCrossing {
  std::size_t a, b;
  Point at;
  double along_a, along_b;
};

/// The crossings of all pairs of segments; nothing where paths touch in another way than crossing.
std::optional<std::vector<PlainCrossing>> PlainCrossings(const std::vector<RobotPath>& paths) {
  std::vector<PlainCrossing> crossings;
  for (std::size_t a = 0; a < paths.size(); ++a) {
    for (std::size_t b = a + 1; b < paths.size(); ++b) {
      for (std::size_t i = 0; i + 1 < paths[a].points.size(); ++i) {
        for (std::size_t j = 0; j + 1 < paths[b].points.size(); ++j) {
          const Point p = paths[a].points[i], q = paths[a].points[i + 1];
          const Point r = paths[b].points[j], s = paths[b].points[j + 1];
          if (OnSegment(p, q, r) || OnSegment(p, q, s) || OnSegment(r, s, p) || OnSegment(r, s, q)) return std::nullopt;
          if (!CrossProperly(p, q, r, s)) continue;
          const double u = Cross(r - p, s - r) / Cross(q - p, s - r);
          const Point at = Lerp(p, q, u);
          crossings.push_back({a, b, at, paths[a].along[i] + Distance(p, at), paths[b].along[j] + Distance(r, at)});
        }
      }
    }
  }
  return crossings;
}

/// Plays one choice of who passes first at each crossing: whether it is possible and makes the layout.
bool Makes(const FleetGround& ground, const FleetLayout& layout, const std::vector<RobotPath>& paths,
           const std::vector<PlainCrossing>& crossings, unsigned choice) {
  struct Stop {
    double along, t;
    std::size_t crossing;
  };
  std::vector<std::vector<Stop>> stops(paths.size());
  for (std::size_t k = 0; k < crossings.size(); ++k) {
    stops[crossings[k].a].push_back({crossings[k].along_a, 0, k});
    stops[crossings[k].b].push_back({crossings[k].along_b, 0, k});
  }
  for (auto& list : stops) {
    std::sort(list.begin(), list.end(), [](const Stop& p, const Stop& q) { return p.along < q.along; });
  }
  const auto first = [&](std::size_t k) { return (choice >> k & 1) != 0 ? crossings[k].a : crossings[k].b; };
  bool changed = true;
  for (std::size_t round = 0; changed; ++round) {
    if (round > 2 * crossings.size() + 2) return false;  // They wait for each other.
    changed = false;
    std::vector<double> passed(crossings.size(), 0);
    for (std::size_t i = 0; i < stops.size(); ++i) {
      for (const Stop& stop : stops[i]) {
        if (first(stop.crossing) == i) passed[stop.crossing] = stop.t;
      }
    }
    for (std::size_t i = 0; i < stops.size(); ++i) {
      double t = 0, along = 0;
      for (Stop& stop : stops[i]) {
        t += (stop.along - along) / ground.robots()[i].speed;
        along = stop.along;
        if (first(stop.crossing) != i) t = std::max(t, passed[stop.crossing]);
        changed = changed || t > stop.t + 1e-12;
        stop.t = std::max(stop.t, t);
        t = stop.t;
      }
    }
  }
  std::vector<RobotSchedule> schedule;
  std::vector<Passing> passings;
  for (std::size_t k = 0; k < crossings.size(); ++k) {
    const bool a_first = first(k) == crossings[k].a;
    Passing passing{.first = RobotId(first(k)), .second = RobotId(a_first ? crossings[k].b : crossings[k].a)};
    passing.at = crossings[k].at;
    passing.first_along = a_first ? crossings[k].along_a : crossings[k].along_b;
    passing.second_along = a_first ? crossings[k].along_b : crossings[k].along_a;
    passings.push_back(passing);
  }
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const double speed = ground.robots()[i].speed;
    RobotSchedule robot{paths[i], {}};
    std::vector<FleetEvent> events;
    for (std::size_t n = 0; n < paths[i].points.size(); ++n) {
      FleetEvent event{.kind = n == 0                            ? FleetEventKind::kStart
                               : n + 1 == paths[i].points.size() ? FleetEventKind::kTarget
                                                                 : FleetEventKind::kBend};
      event.at = paths[i].points[n];
      event.along = paths[i].along[n];
      events.push_back(event);
    }
    for (const Stop& stop : stops[i]) {
      FleetEvent event{.kind = FleetEventKind::kPassing};
      event.at = crossings[stop.crossing].at;
      event.along = stop.along;
      event.passings = {stop.crossing};
      event.departure = stop.t;
      events.push_back(event);
    }
    std::stable_sort(events.begin(), events.end(),
                     [](const FleetEvent& p, const FleetEvent& q) { return p.along < q.along; });
    for (std::size_t e = 1; e < events.size(); ++e) {
      events[e].arrival = events[e - 1].departure + (events[e].along - events[e - 1].along) / speed;
      events[e].departure = std::max(events[e].departure, events[e].arrival);
    }
    robot.events = std::move(events);
    schedule.push_back(std::move(robot));
  }
  const auto played = Play(ground, layout, schedule, passings, {.words_up_to = 0});
  return played && played->differing.empty();
}

/// Whether some order of passing makes the layout.
bool SomeOrderMakes(const FleetGround& ground, const FleetLayout& layout, const std::vector<RobotPath>& paths,
                    const std::vector<PlainCrossing>& crossings) {
  for (unsigned choice = 0; choice < 1U << crossings.size(); ++choice) {
    if (Makes(ground, layout, paths, crossings, choice)) return true;
  }
  return false;
}

std::string Describe(const FleetGround& ground, const FleetLayout& layout) {
  std::string text;
  for (std::size_t i = 0; i < layout.size(); ++i) {
    text += ground.robots()[i].name + ":";
    for (const Point p : PointsOf(ground, layout[i]))
      text += " (" + std::to_string(p.x) + "," + std::to_string(p.y) + ")";
    text += "\n";
  }
  return text;
}

/// What was seen in a series of trials.
struct Tally {
  std::int64_t compared = 0, realizable = 0, pair_deadlocks = 0, network_deadlocks = 0, sequential = 0, entangled = 0;
};

/// Compares the planner with brute force on a layout, and plays its plans of all modes.
void Compare(const FleetGround& ground, const FleetLayout& layout, Tally& tally) {
  const auto paths = ShortestPaths(ground, layout);
  const auto crossings = PlainCrossings(paths);
  constexpr std::size_t kMostCrossings = 8;
  if (!crossings || crossings->size() > kMostCrossings) return;
  const auto plan = PlanFleet(ground, layout);
  ASSERT_TRUE(plan) << Explain(ground, plan.error());
  const bool realizable = plan->modes[0].realizable;
  ASSERT_EQ(realizable, SomeOrderMakes(ground, layout, paths, *crossings));
  ++tally.compared;
  tally.realizable += realizable;
  tally.sequential += plan->modes[1].realizable;
  tally.pair_deadlocks += !plan->pair_deadlocks.empty();
  tally.entangled += !plan->entangled.empty();
  tally.network_deadlocks += !plan->network_deadlocks.empty();
  for (const FleetMode mode : kModes) {
    for (const bool speeds : {false, true}) {
      const auto motion = PlanFleet(ground, layout, {.mode = mode, .speeds = speeds});
      ASSERT_TRUE(motion);
      const auto played = Play(ground, layout, motion->schedule, PassingsToKeep(*motion));
      ASSERT_TRUE(played) << ToString(mode) << " robots " << played.error().a.value() << " and "
                          << played.error().b.value() << " meet";
      ASSERT_TRUE(played->matches()) << ToString(mode) << (speeds ? " speeds" : "") << " differing "
                                     << played->differing.size() << " broken " << played->broken.size();
    }
  }
}

/// One of the shorter layouts of the fleet, or nothing.
std::optional<FleetLayout> RandomLayout(Rng& rng, const FleetGround& ground) {
  constexpr std::size_t kShortest = 60;
  const LayoutsResult found = FindLayouts(ground, {.max_count = kShortest, .budget = 100'000});
  if (found.layouts.empty()) return std::nullopt;
  return found.layouts[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(found.layouts.size()) - 1))].routes;
}

/// A layout of cable lines over nodes at random, without a fault, or nothing.
std::optional<FleetLayout> WildLayout(Rng& rng, const FleetGround& ground) {
  constexpr int kTries = 400;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    FleetLayout layout;
    for (std::size_t i = 0; i < ground.size(); ++i) {
      auto route = RandomRoute(rng, ground, RobotId(i), 2);
      if (!route) break;
      layout.push_back(*std::move(route));
    }
    if (layout.size() == ground.size() && CheckLayout(ground, layout).none()) return layout;
  }
  return std::nullopt;
}

/// Compares the planner with brute force on random layouts until there were `count`. `make` builds a scene.
void CompareMany(std::int64_t count, const std::function<Scene(Rng&, std::uint64_t)>& make, Tally& tally) {
  for (std::uint64_t seed = 1; tally.compared < count; ++seed) {
    Rng rng(seed);
    const Scene scene = make(rng, seed);
    const auto ground = FleetGround::Prepare(scene);
    if (!ground) continue;
    const auto layout = seed % 2 == 0 ? RandomLayout(rng, *ground) : WildLayout(rng, *ground);
    if (!layout) continue;
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + Describe(*ground, *layout));
    Compare(*ground, *layout, tally);
    if (testing::Test::HasFatalFailure()) return;
  }
  std::cout << tally.compared << " layouts: " << tally.realizable << " realizable, " << tally.sequential
            << " one by one, " << tally.pair_deadlocks << " with pair deadlocks, " << tally.network_deadlocks
            << " with network deadlocks, " << tally.entangled << " entangled\n";
  EXPECT_GE(tally.realizable, count / 4);
  EXPECT_GE(tally.pair_deadlocks, count / 50);
}

TEST(PlanFleetRandom, RealizableWhenSomeOrderOfPassingIs) {
  Tally tally;
  const auto make = [](Rng& rng, std::uint64_t seed) {
    const int robots = rng.UniformInt(2, 6);
    return RandomFleet(rng, robots, 12, seed % 3 == 0);
  };
  CompareMany(ScaledTestCount(1000), make, tally);
}

/// Robots among one to three blocks.
Scene AmongBlocks(Rng& rng, std::uint64_t seed) {
  constexpr double kSize = 12;
  const int robots = rng.UniformInt(2, 4);
  Scene scene = RandomFleet(rng, robots, static_cast<int>(kSize), seed % 5 == 0);
  scene.world.outline = {{-1, -1}, {kSize + 1, -1}, {kSize + 1, kSize + 1}, {-1, kSize + 1}};
  for (int k = rng.UniformInt(1, 3); k > 0; --k) {
    const Point low{rng.Uniform(1, kSize - 4), rng.Uniform(1, kSize - 4)};
    const double width = rng.Uniform(0.5, 4), height = rng.Uniform(0.5, 4), lean = rng.Uniform(-1, 1);
    Obstacle block;
    block.polygon = {{low, low + Point{width, lean}, low + Point{width + lean, height}, low + Point{0, height}}, {}};
    scene.world.obstacles.push_back(block);
  }
  return scene;
}

TEST(PlanFleetRandom, RealizableAmongObstaclesWhenSomeOrderOfPassingIs) {
  Tally tally;
  CompareMany(ScaledTestCount(300), AmongBlocks, tally);
}

}  // namespace
}  // namespace tautline
