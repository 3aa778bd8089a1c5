#include "tautline/planners/fleet/layout.h"

#include "tautline/base/check.h"
#include "tautline/geometry/predicates.h"
#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

/// The side that a route from a over b to c turns to.
Side TurnAt(Point a, Point b, Point c) {
  const int turn = Orientation(a, b, c);
  return turn > 0 ? Side::kLeft : turn < 0 ? Side::kRight : Side::kNone;
}

/// Builds one route from the nodes at its bends.
class RouteReader {
 public:
  RouteReader(const FleetGround& ground, RobotId robot) : ground_(ground), robot_(robot) {}

  tl::expected<Route, CableLineFault> Read(std::span<const Point> line) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const auto node = i == 0                 ? ground_.start(robot_)
                        : i + 1 == line.size() ? ground_.target(robot_)
                                               : ground_.NodeAt(line[i]);
      if (!node) return Fault(CableLineObstruction::kBendsInOpen, line[i]);
      if (!route_.empty() && route_.back().node == *node) continue;
      if (!route_.empty()) AddBetween(ground_.point(route_.back().node), ground_.point(*node));
      route_.push_back({*node});
    }
    if (const auto fault = FindDeparture()) return tl::unexpected(*fault);
    for (std::size_t i = 1; i + 1 < route_.size(); ++i) {
      if (!Settle(i)) return Fault(CableLineObstruction::kNotTaut, PointAt(i));
    }
    return route_;
  }

 private:
  Point PointAt(std::size_t i) const { return ground_.point(route_[i].node); }

  tl::unexpected<CableLineFault> Fault(CableLineObstruction obstruction, Point at) const {
    return tl::unexpected(CableLineFault{obstruction, robot_, at});
  }

  void AddBetween(Point a, Point b) {
    for (const FleetNodeId node : ground_.NodesBetween(a, b)) {
      const CornerId corner = ground_.corner_at(node);
      // A corner whose obstacle the line does not touch along its flank is not in the way.
      if (corner.valid() && ground_.space()->corners()[corner].TangentFrom(a) == Side::kNone) continue;
      route_.push_back({node});
    }
  }

  std::optional<CableLineFault> FindDeparture() const {
    if (ground_.space() == nullptr) return std::nullopt;
    std::optional<Walk> walk;
    const auto departure = ground_.space()->Follow(PointsOf(ground_, route_), walk);
    if (!departure) return std::nullopt;
    return CableLineFault{CableLineObstruction::kBlocked, robot_, departure->at};
  }

  /// Decides on which side the route passes a node; false when it cannot stay there.
  bool Settle(std::size_t i) {
    const Point before = PointAt(i - 1), at = PointAt(i), after = PointAt(i + 1);
    const Side turn = TurnAt(before, at, after);
    if (turn == Side::kNone && Dot(at - before, after - at) < 0) return false;
    route_[i].side = turn;
    const CornerId corner = ground_.corner_at(route_[i].node);
    if (!corner.valid()) return true;
    const Side obstacle = ground_.space()->corners()[corner].TangentFrom(before);
    route_[i].side = obstacle;
    return turn == Side::kNone ||
           (turn == obstacle && ground_.space()->corners()[corner].TangentFrom(after) == Opposite(obstacle));
  }

  const FleetGround& ground_;
  RobotId robot_;
  Route route_;
};

}  // namespace

std::string Explain(const FleetGround& ground, const CableLineFault& fault) {
  const std::string cable = "the cable line of " + ground.robot(fault.robot).name;
  const std::string at = ToText(fault.at);
  if (fault.obstruction == CableLineObstruction::kBlocked) {
    return cable + " leaves the free space at " + at + ": lead it around what stands there";
  }
  if (fault.obstruction == CableLineObstruction::kBendsInOpen) {
    return cable + " bends at " + at +
           ", where there is neither the target of another robot nor a corner of an obstacle"
           ": lead it over one, since nothing else holds a taut cable";
  }
  return cable + " turns at " + at + " where nothing would hold it, pulled taut: leave that point out";
}

tl::expected<Route, CableLineFault> ReadRoute(const FleetGround& ground, RobotId robot, std::span<const Point> line) {
  TAUTLINE_CHECK(line.size() >= 2);
  return RouteReader(ground, robot).Read(line);
}

tl::expected<FleetLayout, CableLineFault> ReadLayout(const FleetGround& ground) {
  FleetLayout layout;
  for (std::size_t i = 0; i < ground.size(); ++i) {
    const auto& cable = ground.robots()[i].cable;
    TAUTLINE_CHECK(cable.has_value());
    auto route = ReadRoute(ground, RobotId(i), *cable);
    if (!route) return tl::unexpected(route.error());
    layout.push_back(*std::move(route));
  }
  return layout;
}

Polyline PointsOf(const FleetGround& ground, const Route& route) {
  Polyline points;
  for (const RouteStep& step : route) points.push_back(ground.point(step.node));
  return points;
}

double LengthOf(const FleetGround& ground, const Route& route) {
  double length = 0;
  for (std::size_t i = 1; i < route.size(); ++i) {
    length += Distance(ground.point(route[i - 1].node), ground.point(route[i].node));
  }
  return length;
}

Route BendsOf(const FleetGround& ground, const Route& route) {
  Route bends;
  for (std::size_t i = 0; i < route.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == route.size();
    if (is_end || Orientation(ground.point(route[i - 1].node), ground.point(route[i].node),
                              ground.point(route[i + 1].node)) != 0) {
      bends.push_back(route[i]);
    }
  }
  return bends;
}

}  // namespace tautline
