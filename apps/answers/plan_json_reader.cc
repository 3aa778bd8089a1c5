#include "apps/answers/plan_json_reader.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "tautline/scene/check_tether.h"

namespace tautline {
namespace {

/// Thrown at the first fault, and caught where reading began.
struct PlanFault {
  std::string message;
};

class PlanReader {
 public:
  explicit PlanReader(const FleetSetup& setup) : setup_(setup) {
    for (std::size_t i = 0; i < setup.ground.size(); ++i) by_name_[setup.name(RobotId(i))] = RobotId(i);
  }

  DrivenPlan Read(const Json& json) {
    plan_.schedule.resize(setup_.ground.size());
    for (const Json& entry : json.at("schedule")) {
      const RobotId robot = RobotOf(entry.at("robot"));
      RobotSchedule& schedule = plan_.schedule[robot.index()];
      if (!schedule.events.empty()) throw PlanFault{"it has robot '" + setup_.name(robot) + "' twice"};
      schedule.path = PathOf(robot, entry);
      ReadEvents(robot, entry.at("events"), schedule);
    }
    for (std::size_t i = 0; i < plan_.schedule.size(); ++i) {
      if (plan_.schedule[i].events.empty()) {
        throw PlanFault{"robot '" + setup_.name(RobotId(i)) + "' is missing in its schedule"};
      }
    }
    for (const char* key : {"passings", "detour_passings"}) {
      if (!json.contains(key)) continue;
      for (const Json& entry : json.at(key)) ReadPassing(entry);
    }
    return std::move(plan_);
  }

 private:
  RobotId RobotOf(const Json& name) const {
    const auto found = by_name_.find(name.get<std::string>());
    if (found == by_name_.end()) throw PlanFault{"the scene has no robot '" + name.get<std::string>() + "'"};
    return found->second;
  }

  static Point PointOf(const Json& json) {
    const Point p{json.at(0).get<double>(), json.at(1).get<double>()};
    if (!IsFinite(p)) throw PlanFault{"a point is not finite"};
    return p;
  }

  RobotPath PathOf(RobotId robot, const Json& entry) const {
    const FleetGround& ground = setup_.ground;
    RobotPath path;
    path.is_cable = entry.at("follows_cable").get<bool>();
    Polyline line;
    for (const Json& point : entry.at("path")) line.push_back(PointOf(point));
    const double near = SamePointTolerance(BoundingBox(line));
    if (line.size() < 2 || Distance(line.front(), ground.robot(robot).start) > near ||
        Distance(line.back(), ground.robot(robot).target) > near) {
      throw PlanFault{"the path of '" + setup_.name(robot) + "' does not lead from its start to its target"};
    }
    auto route = ReadRoute(ground, robot, line);
    if (!route) throw PlanFault{"its path: " + Explain(ground, route.error())};
    for (const RouteStep& step : *route) {
      const bool is_end = step.node == ground.start(robot) || step.node == ground.target(robot);
      // Shortest paths know of corners only.
      if (path.is_cable || is_end || ground.corner_at(step.node).valid()) path.route.push_back(step);
    }
    path.points = PointsOf(ground, path.route);
    path.along = {0};
    for (std::size_t i = 1; i < path.points.size(); ++i) {
      path.along.push_back(path.along.back() + Distance(path.points[i - 1], path.points[i]));
    }
    return path;
  }

  void ReadEvents(RobotId robot, const Json& events, RobotSchedule& schedule) {
    for (const Json& entry : events) {
      FleetEvent event;
      event.at = PointOf(entry.at("at"));
      event.along = entry.at("along").get<double>();
      event.departure = entry.at("t").get<double>();
      event.arrival = entry.value("arrival", event.departure);
      const FleetEvent before = schedule.events.empty() ? FleetEvent{} : schedule.events.back();
      if (!(event.along >= before.along && event.arrival >= before.departure && event.departure >= event.arrival &&
            std::isfinite(event.along) && std::isfinite(event.departure))) {
        throw PlanFault{"the events of '" + setup_.name(robot) + "' are not in the order of place and time"};
      }
      if (entry.contains("passings")) {
        for (const Json& label : entry.at("passings")) along_[{robot, label.get<std::string>()}].push_back(event.along);
      }
      schedule.events.push_back(event);
    }
    const double end = schedule.path.length();
    if (schedule.events.size() < 2 || std::fabs(schedule.events.back().along - end) > 1e-6 * (1 + end)) {
      throw PlanFault{"the events of '" + setup_.name(robot) + "' do not lead to the end of its path"};
    }
    schedule.events.front().along = 0;
    schedule.events.back().along = end;
  }

  void ReadPassing(const Json& entry) {
    Passing passing;
    passing.first = RobotOf(entry.at("robots").at(0));
    passing.second = RobotOf(entry.at("robots").at(1));
    passing.at = PointOf(entry.at("at"));
    passing.label = entry.at("label").get<std::string>();
    const auto first = along_.find({passing.first, passing.label});
    const auto second = along_.find({passing.second, passing.label});
    // Crossings of straight paths that a detour leaves out are no events.
    if (first == along_.end() || second == along_.end()) return;
    passing.first_along = first->second.back();
    passing.second_along = second->second.front();
    plan_.passings.push_back(passing);
  }

  const FleetSetup& setup_;
  std::map<std::string, RobotId> by_name_;
  std::map<std::pair<RobotId, std::string>, std::vector<double>> along_;
  DrivenPlan plan_;
};

}  // namespace

Expected<DrivenPlan> ReadDrivenPlan(const FleetSetup& setup, const Json& json, const std::string& file) {
  try {
    return PlanReader(setup).Read(json);
  } catch (const PlanFault& fault) {
    return InvalidInput("this is no plan for the fleet: " + fault.message + "; make one with `fleet plan --json`",
                        file);
  } catch (const Json::exception& exception) {
    return InvalidInput("this is no result of `fleet plan --json`: " + std::string(exception.what()), file);
  }
}

}  // namespace tautline
