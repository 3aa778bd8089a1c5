#include "tautline/planners/fleet/playback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/predicates.h"
#include "tautline/planners/fleet/check_layout.h"
#include "tautline/planners/fleet/plan_fleet.h"
#include "tautline/planners/fleet/random_fleet.h"
#include "tautline/planners/fleet/robot_paths.h"

namespace tautline {
namespace {

FleetRobot Robot(const std::string& name, Polyline cable, double speed = 1) {
  FleetRobot robot;
  robot.name = name;
  robot.start = cable.front();
  robot.target = cable.back();
  robot.cable = std::move(cable);
  robot.speed = speed;
  return robot;
}

Scene SceneOf(std::vector<FleetRobot> robots) {
  Scene scene;
  scene.fleet = Fleet{std::move(robots)};
  return scene;
}

/// The cable lines of Fig. 1: each bends around the target of the next robot, in a circle.
Scene Circle() {
  return SceneOf({Robot("r1", {{-6.8, -1.9}, {-3.6, -5}, {6.1, -0.6}}),
                  Robot("r2", {{5, -5}, {6.1, -0.6}, {-2.5, 5.6}}),
                  Robot("r3", {{1.8, 6.9}, {-2.5, 5.6}, {-3.6, -5}})});
}

RobotPath StraightPath(const FleetGround& ground, RobotId id) {
  RobotPath path;
  path.route = {{ground.start(id)}, {ground.target(id)}};
  path.points = PointsOf(ground, path.route);
  path.along = {0, Distance(path.points[0], path.points[1])};
  return path;
}

RobotPath CablePath(const FleetGround& ground, const Route& route) {
  RobotPath path;
  path.route = route;
  path.points = PointsOf(ground, route);
  path.along = {0};
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    path.along.push_back(path.along.back() + Distance(path.points[i - 1], path.points[i]));
  }
  path.is_cable = true;
  return path;
}

/// Drives at speed 1 without a stop.
RobotSchedule Drive(RobotPath path, double start) {
  RobotSchedule robot;
  const auto event = [&](FleetEventKind kind, std::size_t k, double t) {
    FleetEvent e;
    e.kind = kind;
    e.at = path.points[k];
    e.along = path.along[k];
    e.arrival = e.departure = t;
    return e;
  };
  robot.events.push_back(event(FleetEventKind::kStart, 0, 0));
  robot.events.back().departure = start;
  for (std::size_t k = 1; k < path.points.size(); ++k) {
    const bool last = k + 1 == path.points.size();
    robot.events.push_back(event(last ? FleetEventKind::kTarget : FleetEventKind::kBend, k, start + path.along[k]));
  }
  robot.path = std::move(path);
  return robot;
}

/// One robot after the other, in an order.
std::vector<RobotSchedule> InTurns(const FleetGround& ground, const std::vector<std::size_t>& order,
                                   const FleetLayout* along = nullptr) {
  std::vector<RobotSchedule> schedule(ground.size());
  double t = 0;
  for (const std::size_t i : order) {
    schedule[i] = Drive(along ? CablePath(ground, (*along)[i]) : StraightPath(ground, RobotId(i)), t);
    t = schedule[i].events.back().arrival;
  }
  return schedule;
}

std::string Text(const FleetGround& ground, const Route& route) {
  std::string text;
  for (const RouteStep& step : route) {
    const RobotId robot = ground.robot_at(step.node);
    text += (text.empty() ? "" : " ") + (robot.valid() ? (ground.kind(step.node) == FleetNodeKind::kStart ? "S" : "T") +
                                                             std::to_string(robot.index() + 1)
                                                       : "c" + std::to_string(ground.corner_at(step.node).index()));
    if (step.side != Side::kNone) text += step.side == Side::kLeft ? "L" : "R";
  }
  return text;
}

std::string TextOf(const FleetGround& ground, const FleetLayout& layout) {
  std::string text;
  for (const Route& route : layout) text += Text(ground, route) + "\n";
  return text;
}

// r1 drives along the bottom, r2 up through its path: whoever is second pushes or meets the other's cable.
TEST(Playback, TwoRobotsAndBothOrders) {
  const auto ground =
      FleetGround::Prepare(SceneOf({Robot("r1", {{0, 0}, {5.5, 5}, {10, 1}}), Robot("r2", {{5, -5}, {5.5, 5}})}));
  ASSERT_TRUE(ground.has_value());
  const auto layout = ReadLayout(*ground);
  ASSERT_TRUE(layout.has_value());
  const auto right = Play(*ground, *layout, InTurns(*ground, {0, 1}), {});
  ASSERT_TRUE(right.has_value());
  EXPECT_TRUE(right->matches());
  EXPECT_EQ(right->words_agree, true);
  EXPECT_EQ(Text(*ground, right->final_routes[0]), "S1 T2R T1");
  EXPECT_DOUBLE_EQ(right->longest[0].length, Distance({0, 0}, {5.5, 5}) + Distance({5.5, 5}, {10, 1}));
  EXPECT_DOUBLE_EQ(right->longest[0].t, right->longest[1].t);
  const auto wrong = Play(*ground, *layout, InTurns(*ground, {1, 0}), {});
  ASSERT_TRUE(wrong.has_value());
  EXPECT_EQ(wrong->differing, (std::vector{RobotId(0), RobotId(1)}));
  EXPECT_EQ(wrong->words_agree, false);
  EXPECT_EQ(Text(*ground, wrong->final_routes[0]), "S1 T1");
}

TEST(Playback, NoOrderOfOneAfterTheOtherMakesTheCircleAndAllAtOnceDo) {
  const auto ground = FleetGround::Prepare(Circle());
  ASSERT_TRUE(ground.has_value());
  const auto layout = ReadLayout(*ground);
  ASSERT_TRUE(layout.has_value());
  std::vector<std::size_t> order{0, 1, 2};
  do {
    const auto playback = Play(*ground, *layout, InTurns(*ground, order), {});
    ASSERT_TRUE(playback.has_value());
    EXPECT_FALSE(playback->matches());
    EXPECT_EQ(playback->words_agree, false);
    const auto bent = Play(*ground, *layout, InTurns(*ground, order, &*layout), {});
    ASSERT_TRUE(bent.has_value());
    EXPECT_TRUE(bent->matches()) << "along the cable lines any order will do";
    EXPECT_EQ(bent->words_agree, true);
  } while (std::next_permutation(order.begin(), order.end()));
  for (const FleetMode mode : {FleetMode::kStraightConcurrent, FleetMode::kStraightSequential,
                               FleetMode::kBentConcurrent, FleetMode::kBentSequential}) {
    const auto plan = PlanFleet(*ground, *layout, {.mode = mode, .gap = {}});
    ASSERT_TRUE(plan.has_value());
    std::vector<Passing> passings;
    if (plan->detours.empty() && mode == FleetMode::kStraightConcurrent) passings = plan->passings;
    passings.insert(passings.end(), plan->detour_passings.begin(), plan->detour_passings.end());
    const auto playback = Play(*ground, *layout, plan->schedule, passings);
    ASSERT_TRUE(playback.has_value()) << ToString(mode);
    EXPECT_TRUE(playback->matches()) << ToString(mode);
  }
}

TEST(Playback, BrokenOrdersAreTold) {
  const auto ground = FleetGround::Prepare(SceneOf({Robot("r1", {{0, 0}, {10, 0}}), Robot("r2", {{5, -5}, {5, 5}})}));
  ASSERT_TRUE(ground.has_value());
  Passing passing;
  passing.first = RobotId(1);
  passing.second = RobotId(0);
  passing.at = {5, 0};
  passing.first_along = passing.second_along = 5;
  const auto broken = Play(*ground, {}, InTurns(*ground, {0, 1}), {passing});
  ASSERT_TRUE(broken.has_value());
  ASSERT_EQ(broken->broken.size(), 1u);
  EXPECT_EQ(broken->broken[0].first, RobotId(1));
  EXPECT_FALSE(broken->matches());
  EXPECT_TRUE(broken->differing.empty()) << "no layout, nothing that differs";
  EXPECT_FALSE(broken->words_agree.has_value());
  const auto kept = Play(*ground, {}, InTurns(*ground, {1, 0}), {passing});
  ASSERT_TRUE(kept.has_value());
  EXPECT_TRUE(kept->matches());
  // Both at once: then the order decides.
  const std::vector<RobotSchedule> at_once{Drive(StraightPath(*ground, RobotId(0)), 0),
                                           Drive(StraightPath(*ground, RobotId(1)), 0)};
  const auto tie = Play(*ground, {}, at_once, {passing});
  ASSERT_TRUE(tie.has_value());
  EXPECT_EQ(tie->final_routes, kept->final_routes);
  const auto meet = Play(*ground, {}, at_once, {});
  ASSERT_FALSE(meet.has_value());
  EXPECT_EQ(meet.error().at, (Point{5, 0}));
  EXPECT_DOUBLE_EQ(meet.error().t, 5);
}

TEST(Playback, OverABaseOrOverARobotThatHasArrivedIsNoWay) {
  const auto ground = FleetGround::Prepare(
      SceneOf({Robot("r1", {{0, 0}, {10, 0}}), Robot("r2", {{5, 0}, {5, 5}}), Robot("r3", {{7, 4}, {7, 0}})}));
  ASSERT_TRUE(ground.has_value());
  const auto base = Play(*ground, {}, InTurns(*ground, {0, 1, 2}), {});
  ASSERT_FALSE(base.has_value());
  const auto free = FleetGround::Prepare(SceneOf({Robot("r1", {{0, 0}, {10, 0}}), Robot("r3", {{7, 4}, {7, 0}})}));
  const auto before = Play(*free, {}, InTurns(*free, {0, 1}), {});
  ASSERT_TRUE(before.has_value());
  EXPECT_EQ(Text(*free, before->final_routes[0]), "S1 T2L T1");
  const auto after = Play(*free, {}, InTurns(*free, {1, 0}), {});
  ASSERT_FALSE(after.has_value());
  EXPECT_EQ(after.error().at, (Point{7, 0}));
}

TEST(Playback, HeadOnOnOneLineIsNoWay) {
  const auto ground = FleetGround::Prepare(SceneOf({Robot("r1", {{0, 0}, {9, 3}}), Robot("r2", {{12, 4}, {3, 1}})}));
  ASSERT_TRUE(ground.has_value());
  EXPECT_FALSE(Play(*ground, {}, InTurns(*ground, {0, 1}), {}).has_value());
  EXPECT_FALSE(Play(*ground, {}, InTurns(*ground, {1, 0}), {}).has_value());
}

TEST(Playback, FramesAreSpreadOverTheMotion) {
  const auto ground = FleetGround::Prepare(Circle());
  const auto layout = ReadLayout(*ground);
  const auto playback = Play(*ground, *layout, InTurns(*ground, {0, 1, 2}), {}, {.frames = 11});
  ASSERT_TRUE(playback.has_value());
  ASSERT_EQ(playback->frames.size(), 11u);
  const auto schedule = InTurns(*ground, {0, 1, 2});
  for (const PlaybackFrame& frame : playback->frames) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LT(Distance(frame.robots[i], PositionAt(schedule[i], frame.t)), 1e-5);
      EXPECT_EQ(frame.cables[i].back(), frame.robots[i]);
      EXPECT_LE(Length(frame.cables[i]), playback->longest[i].length + 1e-5);
    }
  }
  EXPECT_EQ(playback->frames.back().robots[0], (Point{6.1, -0.6}));
}

/// Whether a cable turns straight back around the end of another, as no cable line may.
bool TurnsBack(const FleetGround& ground, const Route& route) {
  const Polyline points = PointsOf(ground, route);
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Point in = points[i] - points[i - 1], out = points[i + 1] - points[i];
    if (Orientation(points[i - 1], points[i], points[i + 1]) == 0 && Dot(in, out) < 0) return true;
  }
  return false;
}

/// What random robots make that drive straight one after the other is a layout; so is what they make along its lines,
/// in any order and all at once, and all of it is longest at the moments that are measured.
TEST(Playback, LayoutsThatCameOutComeOutAgainAlongTheirLines) {
  const std::int64_t count = ScaledTestCount(1500);
  std::int64_t played = 0, bent = 0, differing = 0;
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const bool on_lattice = rng.UniformInt(0, 1) == 0;
    const Scene scene = RandomFleet(rng, rng.UniformInt(2, 8), on_lattice ? 8 : 10, on_lattice);
    const auto ground = FleetGround::Prepare(scene);
    ASSERT_TRUE(ground.has_value());
    std::vector<std::size_t> order(ground->size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto shuffle = [&] {
      for (std::size_t i = order.size(); i-- > 1;) {
        std::swap(order[i], order[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(i)))]);
      }
    };
    shuffle();
    const auto straight = InTurns(*ground, order);
    const auto first = Play(*ground, {}, straight, {});
    if (!first) continue;
    const FleetLayout& layout = first->final_routes;
    if (std::any_of(layout.begin(), layout.end(), [&](const Route& r) { return TurnsBack(*ground, r); })) continue;
    ++played;
    for (const Route& route : layout) bent += route.size() > 2 ? 1 : 0;
    const auto again = Play(*ground, layout, straight, {});
    ASSERT_TRUE(again.has_value());
    for (std::size_t i = 0; i < layout.size(); ++i) {
      ASSERT_EQ(Text(*ground, again->final_routes[i]), Text(*ground, layout[i]));
    }
    ASSERT_TRUE(again->matches()) << TextOf(*ground, layout);
    const auto frames = Play(*ground, layout, straight, {}, {.frames = 40});
    ASSERT_TRUE(frames.has_value());
    for (const PlaybackFrame& frame : frames->frames) {
      for (std::size_t i = 0; i < ground->size(); ++i) {
        ASSERT_LE(Length(frame.cables[i]), first->longest[i].length + 1e-5);
      }
    }
    for (int k = 0; k < 2; ++k) {
      shuffle();
      auto schedule = InTurns(*ground, order, &layout);
      if (k == 1) {
        for (std::size_t i = 0; i < ground->size(); ++i) {
          schedule[i] = Drive(CablePath(*ground, layout[i]), rng.UniformInt(0, 3));
        }
      }
      const auto playback = Play(*ground, layout, schedule, {});
      ASSERT_TRUE(playback.has_value()) << playback.error().a.value() << " meets " << playback.error().b.value();
      for (std::size_t i = 0; i < ground->size(); ++i) {
        ASSERT_EQ(Text(*ground, BendsOf(*ground, playback->final_routes[i])),
                  Text(*ground, BendsOf(*ground, layout[i])))
            << i << " was " << Text(*ground, layout[i]);
      }
      ASSERT_TRUE(playback->matches());
    }
    shuffle();
    const auto other = Play(*ground, layout, InTurns(*ground, order), {});
    if (other && !other->differing.empty()) ++differing;
    if (other && other->words_agree) {
      ASSERT_EQ(*other->words_agree, other->differing.empty());
    }
  }
  EXPECT_GT(played, count / 3);
  EXPECT_GT(bent, played);
  EXPECT_GT(differing, played / 4);
}

}  // namespace
}  // namespace tautline
