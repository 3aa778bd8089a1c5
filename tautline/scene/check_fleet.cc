#include "tautline/scene/check_fleet.h"

#include <map>
#include <set>
#include <string>

#include "tautline/scene/check_tether.h"
#include "tautline/scene/number_text.h"
#include "tautline/scene/scene_fault.h"

namespace tautline {
namespace {

std::string Nth(std::size_t i) { return "fleet.robots[" + std::to_string(i + 1) + "]"; }

Expected<void> CheckNumbers(const FleetRobot& robot, const std::string& what) {
  if (auto start = Checked(what + ".start", PointFault(robot.start)); !start) return start;
  if (auto target = Checked(what + ".target", PointFault(robot.target)); !target) return target;
  if (auto speed = Checked(what + ".speed", PositiveFault(robot.speed)); !speed) return speed;
  if (auto radius = Checked(what + ".radius", NonNegativeFault(robot.radius)); !radius) return radius;
  return robot.tether ? Checked(what + ".tether", NonNegativeFault(*robot.tether)) : Expected<void>{};
}

Expected<void> CheckCable(const FleetRobot& robot, const std::string& what, double tolerance) {
  if (!robot.cable) return {};
  const Polyline& cable = *robot.cable;
  if (cable.size() < 2) {
    return InvalidInput(what + " has " + std::to_string(cable.size()) + " points: it needs 2 or more");
  }
  if (auto points = Checked(what, PointsFault(cable)); !points) return points;
  if (Distance(cable.front(), robot.start) > tolerance) {
    return InvalidInput(what + " must begin at the start, at " + ToText(robot.start) + ", not at " +
                        ToText(cable.front()));
  }
  if (Distance(cable.back(), robot.target) > tolerance) {
    return InvalidInput(what + " must end at the target, at " + ToText(robot.target) + ", not at " +
                        ToText(cable.back()));
  }
  return {};
}

/// Where robots start and end, each by the words that name it.
class Places {
 public:
  Expected<void> Add(Point at, const std::string& what) {
    const auto [place, is_new] = names_.try_emplace(at, what);
    if (is_new) return {};
    return InvalidInput(what + " is where " + place->second + " is, at " + ToText(at) +
                        ": move one, since cables must be able to tell them apart");
  }

 private:
  std::map<Point, std::string> names_;
};

}  // namespace

Expected<void> CheckFleet(const Fleet& fleet) {
  if (fleet.robots.empty()) return InvalidInput("fleet.robots is empty: list a robot");
  std::set<std::string> names;
  Places places;
  Polyline ends;
  for (std::size_t i = 0; i < fleet.robots.size(); ++i) {
    const FleetRobot& robot = fleet.robots[i];
    if (robot.name.empty()) return InvalidInput(Nth(i) + " has no name: give it one");
    if (!names.insert(robot.name).second) {
      return InvalidInput("two robots are named '" + robot.name + "': rename one");
    }
    if (auto numbers = CheckNumbers(robot, Nth(i)); !numbers) return numbers;
    if (auto start = places.Add(robot.start, "the start of " + robot.name); !start) return start;
    if (auto target = places.Add(robot.target, "the target of " + robot.name); !target) return target;
    ends.insert(ends.end(), {robot.start, robot.target});
  }
  const double tolerance = SamePointTolerance(BoundingBox(ends));
  for (std::size_t i = 0; i < fleet.robots.size(); ++i) {
    if (auto cable = CheckCable(fleet.robots[i], Nth(i) + ".cable", tolerance); !cable) return cable;
  }
  return {};
}

Expected<void> RequireFleet(const Scene& scene) {
  if (!scene.fleet) {
    return InvalidInput("the scene has no fleet; add `fleet: {speed: S, robots: [{start: [x, y], target: [x, y]}]}`",
                        scene.path);
  }
  return InScene(scene, CheckFleet(*scene.fleet));
}

}  // namespace tautline
