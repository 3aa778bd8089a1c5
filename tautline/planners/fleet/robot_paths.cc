#include "tautline/planners/fleet/robot_paths.h"

#include <map>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

RobotPath PathOf(const FleetGround& ground, Route route, bool is_cable) {
  RobotPath path{.route = std::move(route), .points = {}, .along = {0}, .is_cable = is_cable};
  path.points = PointsOf(ground, path.route);
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    path.along.push_back(path.along.back() + Distance(path.points[i - 1], path.points[i]));
  }
  return path;
}

/// Finds the corners at the bends of taut curves. By place, since a robot's node may be there too.
class CornerFinder {
 public:
  explicit CornerFinder(const FleetGround& ground) : ground_(ground) {
    const auto corners = ground.space()->corners().all();
    for (std::size_t i = 0; i < corners.size(); ++i) by_place_.emplace(corners[i].point, CornerId(i));
  }

  /// The step of a path that comes from `from` and bends at `at`; where blocked ground touches, several corners are in
  /// one place, and one of them is tangent.
  RouteStep StepAt(Point from, Point at) const {
    const auto [begin, end] = by_place_.equal_range(at);
    for (auto found = begin; found != end; ++found) {
      const Side side = ground_.space()->corners()[found->second].TangentFrom(from);
      if (side != Side::kNone) return {ground_.corner(found->second), side};
    }
    TAUTLINE_CHECK(begin != end);
    return {ground_.corner(begin->second), Side::kNone};
  }

  /// Appends the corners that the segment grazes.
  void AddGrazed(Point from, Point to, Route& route) const {
    for (const FleetNodeId node : ground_.NodesBetween(from, to)) {
      const CornerId corner = ground_.corner_at(node);
      if (!corner.valid()) continue;
      const Side side = ground_.space()->corners()[corner].TangentFrom(from);
      if (side != Side::kNone) route.push_back({node, side});
    }
  }

 private:
  const FleetGround& ground_;
  std::multimap<Point, CornerId> by_place_;
};

Route TautRoute(const FleetGround& ground, const CornerFinder& corners, RobotId robot, const Route& cable) {
  const Shortened taut = Shorten(*ground.space(), PointsOf(ground, cable));
  TAUTLINE_CHECK(!taut.departure);
  const Polyline& points = taut.path.points;
  Route route{{ground.start(robot)}};
  for (std::size_t i = 1; i < points.size(); ++i) {
    corners.AddGrazed(points[i - 1], points[i], route);
    if (i + 1 < points.size()) route.push_back(corners.StepAt(points[i - 1], points[i]));
  }
  route.push_back({ground.target(robot)});
  return route;
}

}  // namespace

std::vector<RobotPath> ShortestPaths(const FleetGround& ground, const FleetLayout& layout) {
  std::vector<RobotPath> paths;
  if (ground.space() == nullptr) {
    for (std::size_t i = 0; i < ground.size(); ++i) {
      const RobotId robot(i);
      paths.push_back(PathOf(ground, {{ground.start(robot)}, {ground.target(robot)}}, false));
    }
    return paths;
  }
  const CornerFinder corners(ground);
  for (std::size_t i = 0; i < ground.size(); ++i) {
    paths.push_back(PathOf(ground, TautRoute(ground, corners, RobotId(i), layout[i]), false));
  }
  return paths;
}

RobotPath CablePath(const FleetGround& ground, const FleetLayout& layout, RobotId robot) {
  return PathOf(ground, layout[robot.index()], true);
}

}  // namespace tautline
