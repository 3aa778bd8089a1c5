#include "tautline/draw/example_fleet.h"

#include <algorithm>

#include "tautline/base/rng.h"
#include "tautline/draw/draw_fleet.h"

namespace tautline {
namespace {

/// Where two segments cross, as parts of both; they must not be parallel.
std::pair<double, double> CrossingOf(Point a, Point b, Point c, Point d) {
  const Point u = b - a, v = d - c;
  const double area = Cross(u, v);
  return {Cross(c - a, v) / area, Cross(c - a, u) / area};
}

RobotSchedule Straight(const FleetGround& ground, RobotId id) {
  const FleetRobot& robot = ground.robot(id);
  const double length = Distance(robot.start, robot.target);
  RobotSchedule schedule;
  schedule.path = {
      .route = {{ground.start(id)}, {ground.target(id)}}, .points = {robot.start, robot.target}, .along = {0, length}};
  schedule.events = {{.kind = FleetEventKind::kStart, .at = robot.start, .passings = {}},
                     {.kind = FleetEventKind::kTarget, .at = robot.target, .along = length, .passings = {}}};
  return schedule;
}

void AddEvent(FleetPlan& plan, RobotId robot, double along, std::size_t passing) {
  auto& events = plan.schedule[robot.index()].events;
  const auto place = std::partition_point(events.begin(), events.end(),
                                          [along](const FleetEvent& event) { return event.along < along; });
  events.insert(
      place,
      {.kind = FleetEventKind::kPassing, .at = plan.passings[passing].at, .along = along, .passings = {passing}});
}

/// Earliest times, by repeated passes until nothing moves.
void Schedule(const FleetGround& ground, FleetPlan& plan) {
  for (std::size_t round = 0; round <= plan.passings.size() + 1; ++round) {
    for (std::size_t i = 0; i < plan.schedule.size(); ++i) {
      auto& events = plan.schedule[i].events;
      for (std::size_t k = 0; k < events.size(); ++k) {
        FleetEvent& event = events[k];
        if (k > 0) {
          event.arrival = events[k - 1].departure + (event.along - events[k - 1].along) / ground.robots()[i].speed;
        }
        event.departure = event.arrival;
        for (const std::size_t p : event.passings) {
          if (plan.passings[p].second != RobotId(i)) continue;
          for (const FleetEvent& other : plan.schedule[plan.passings[p].first.index()].events) {
            if (other.passings == event.passings) event.departure = std::max(event.departure, other.departure);
          }
        }
      }
    }
  }
}

}  // namespace

Scene TriangleScene() {
  Scene scene;
  const std::vector<Point> starts = {{-6.8, -1.9}, {5.1, -5.0}, {1.8, 6.9}};
  const std::vector<Point> targets = {{6.1, -0.6}, {-2.5, 5.6}, {-3.6, -5.0}};
  scene.fleet.emplace();
  for (std::size_t i = 0; i < 3; ++i) {
    const Point bend = targets[i == 0 ? 2 : i == 1 ? 0 : 1];
    scene.fleet->robots.push_back({.name = "r" + std::to_string(i + 1),
                                   .start = starts[i],
                                   .target = targets[i],
                                   .cable = Polyline{starts[i], bend, targets[i]},
                                   .speed = 0.5,
                                   .tether = {}});
  }
  return scene;
}

Scene CrowdScene(std::size_t count) {
  Rng rng(7);
  Scene scene;
  scene.fleet.emplace();
  for (std::size_t i = 0; i < count; ++i) {
    const Point start{100 * rng.Uniform(), 60 * rng.Uniform()};
    const Point target = start + Point{8 * rng.Uniform() - 4, 8 * rng.Uniform() - 4};
    scene.fleet->robots.push_back({.name = "r" + std::to_string(i + 1),
                                   .start = start,
                                   .target = target,
                                   .cable = Polyline{start, target},
                                   .speed = 1,
                                   .tether = {}});
  }
  return scene;
}

FleetPlan HandMadePlan(const FleetGround& ground, const std::vector<std::pair<int, int>>& orders) {
  FleetPlan plan;
  for (std::size_t i = 0; i < ground.size(); ++i) plan.schedule.push_back(Straight(ground, RobotId(i)));
  for (const auto& [first, second] : orders) {
    const RobotId a(static_cast<std::size_t>(first)), b(static_cast<std::size_t>(second));
    const RobotPath &one = plan.schedule[a.index()].path, &other = plan.schedule[b.index()].path;
    const auto [s, t] = CrossingOf(one.points[0], one.points[1], other.points[0], other.points[1]);
    plan.passings.push_back({.first = a,
                             .second = b,
                             .at = Lerp(one.points[0], one.points[1], s),
                             .label = std::string(1, static_cast<char>('A' + plan.passings.size())),
                             .first_along = s * one.length(),
                             .second_along = t * other.length()});
    AddEvent(plan, a, plan.passings.back().first_along, plan.passings.size() - 1);
    AddEvent(plan, b, plan.passings.back().second_along, plan.passings.size() - 1);
  }
  Schedule(ground, plan);
  for (const RobotSchedule& schedule : plan.schedule) {
    plan.travel_time = std::max(plan.travel_time, schedule.events.back().arrival);
    plan.travel_distance += schedule.path.length();
  }
  plan.modes.fill(
      {.realizable = true, .detours = {}, .travel_time = plan.travel_time, .travel_distance = plan.travel_distance});
  return plan;
}

std::vector<PlaybackFrame> HandMadeFrames(const FleetGround& ground, const FleetLayout& layout, const FleetPlan& plan,
                                          int count) {
  std::vector<PlaybackFrame> frames;
  for (int k = 0; k < count; ++k) {
    PlaybackFrame frame{.t = plan.travel_time * k / (count - 1), .robots = {}, .cables = {}};
    for (std::size_t i = 0; i < ground.size(); ++i) {
      frame.robots.push_back(PositionAt(plan.schedule[i], frame.t));
      frame.cables.push_back(k + 1 == count ? PointsOf(ground, layout[i])
                                            : Polyline{ground.robots()[i].start, frame.robots.back()});
    }
    frames.push_back(std::move(frame));
  }
  return frames;
}

std::vector<NamedPicture> FleetPictures() {
  std::vector<NamedPicture> pictures;
  const Scene scene = TriangleScene(), crowd = CrowdScene(1000);
  const auto ground = FleetGround::Prepare(scene).value(), crowd_ground = FleetGround::Prepare(crowd).value();
  const auto layout = ReadLayout(ground).value(), crowd_layout = ReadLayout(crowd_ground).value();
  const FleetPlan plan = HandMadePlan(ground, {{1, 0}, {0, 2}, {2, 1}});
  const LayoutPicture marked{.title = "Three cable lines", .notes = {}, .layout = &layout, .marks = {{{1, 1}, "here"}}};
  pictures.push_back({"fleet_layout", DrawLayout(scene, ground, marked)});
  const std::vector<const FleetLayout*> layouts(7, &layout);
  pictures.push_back(
      {"fleet_layouts", DrawLayouts(scene, ground, {.title = "Seven layouts", .notes = {}, .layouts = layouts})});
  pictures.push_back({"fleet_plan", DrawFleetPlan(scene, ground, {.layout = layout, .plan = plan})});
  FleetPlan detour = plan;
  detour.pair_deadlocks = {{RobotId(0), RobotId(1)}};
  detour.detours = {RobotId(1)};
  detour.schedule[1].path = {.route = layout[1],
                             .points = PointsOf(ground, layout[1]),
                             .along = {0, 4.5, LengthOf(ground, layout[1])},
                             .is_cable = true};
  pictures.push_back({"fleet_detour", DrawFleetPlan(scene, ground, {.layout = layout, .plan = detour})});
  pictures.push_back({"fleet_crowd", DrawFleetPlan(crowd, crowd_ground,
                                                   {.layout = crowd_layout, .plan = HandMadePlan(crowd_ground, {})})});
  Playback playback{.final_routes = layout, .longest = {}, .frames = {}, .words_agree = {}};
  playback.final_routes[1] = {layout[1].front(), layout[1].back()};
  playback.differing = {RobotId(1)};
  pictures.push_back({"fleet_simulate", DrawSimulate(scene, ground, {.layout = layout, .playback = playback})});
  const auto frames = HandMadeFrames(ground, layout, plan, 20);
  pictures.push_back({"fleet_film", AnimateFleet(scene, ground, {.layout = layout, .plan = plan, .frames = frames})});
  return pictures;
}

}  // namespace tautline
