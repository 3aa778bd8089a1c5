// Random fleets and cable lines for tests.
#ifndef TAUTLINE_PLANNERS_FLEET_RANDOM_FLEET_H_
#define TAUTLINE_PLANNERS_FLEET_RANDOM_FLEET_H_

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "tautline/base/rng.h"
#include "tautline/planners/fleet/layout.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// For tests only: starts and targets of `robots` robots at different places, on whole numbers up to `size`, or
/// anywhere in that square.
inline Scene RandomFleet(Rng& rng, int robots, int size, bool on_lattice) {
  Scene scene;
  scene.fleet.emplace();
  std::set<Point> taken;
  const auto place = [&] {
    Point p;
    do {
      p = on_lattice ? Point{static_cast<double>(rng.UniformInt(0, size)), static_cast<double>(rng.UniformInt(0, size))}
                     : Point{rng.Uniform(0, size), rng.Uniform(0, size)};
    } while (!taken.insert(p).second);
    return p;
  };
  for (int i = 0; i < robots; ++i) {
    FleetRobot robot;
    robot.name = "r" + std::to_string(i + 1);
    robot.start = place();
    robot.target = place();
    robot.speed = 1;
    scene.fleet->robots.push_back(robot);
  }
  return scene;
}

/// For tests only: a line from the start to the target of a robot over up to `bends` ends of others; nothing when it
/// turns back or passes a node twice.
inline std::optional<Route> RandomRoute(Rng& rng, const FleetGround& ground, RobotId robot, int bends) {
  Polyline line{ground.robot(robot).start};
  for (int k = rng.UniformInt(0, bends); k > 0; --k) {
    // Targets rather than starts, as in layouts that obey the assumptions.
    const auto other = static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(ground.size()) - 1));
    const FleetRobot& pin = ground.robots()[other];
    if (RobotId(other) != robot) line.push_back(rng.UniformInt(0, 4) == 0 ? pin.start : pin.target);
  }
  line.push_back(ground.robot(robot).target);
  auto route = ReadRoute(ground, robot, line);
  if (!route) return std::nullopt;
  std::set<FleetNodeId> nodes;
  for (const RouteStep& step : *route) {
    if (!nodes.insert(step.node).second) return std::nullopt;
  }
  return *std::move(route);
}

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_RANDOM_FLEET_H_
