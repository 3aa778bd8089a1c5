#include "apps/answers/fleet_setup.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace tautline {
namespace {

const char* ToString(CableLineObstruction obstruction) {
  switch (obstruction) {
    case CableLineObstruction::kBlocked:
      return "cable_blocked";
    case CableLineObstruction::kBendsInOpen:
      return "cable_bends_in_open";
    case CableLineObstruction::kNotTaut:
      return "cable_not_taut";
  }
  return "";
}

/// Coordinates that the free space moved onto its grid come back as they were written.
double Rounded(double value) {
  constexpr double kPerMetre = 1e9, kLargestRounded = 1e6;
  return std::fabs(value) < kLargestRounded ? std::round(value * kPerMetre) / kPerMetre + 0.0 : value;
}

}  // namespace

Expected<FleetSetup> SetUpFleet(const Scene& scene, const Watcher& watch) {
  auto ground = FleetGround::Prepare(scene, watch);
  if (!ground) return tl::unexpected(ground.error());
  FleetSetup setup{*std::move(ground), std::nullopt};
  const auto& robots = setup.ground.robots();
  const auto has_cable = [](const FleetRobot& robot) { return robot.cable.has_value(); };
  if (std::none_of(robots.begin(), robots.end(), has_cable)) return setup;
  const auto bare = std::find_if_not(robots.begin(), robots.end(), has_cable);
  if (bare != robots.end()) {
    return InvalidInput("robot " + bare->name +
                            " has no cable line and others have one: add `cable` to it, or leave all "
                            "of them out",
                        scene.path);
  }
  setup.layout = ReadLayout(setup.ground);
  return setup;
}

Expected<FleetSetup> SetUpFleetLayout(const Scene& scene, const Watcher& watch) {
  auto setup = SetUpFleet(scene, watch);
  if (setup && !setup->layout) {
    return InvalidInput("the robots have no cable lines: add `cable: [[x, y], ...]`, start to target, to each of them",
                        scene.path);
  }
  return setup;
}

void AddCableLineFault(const FleetSetup& setup, const CableLineFault& fault, Json& json) {
  json["status"] = "infeasible";
  json["reason"] = ToString(fault.obstruction);
  json["explanation"] = Explain(setup.ground, fault);
  json["robot"] = setup.name(fault.robot);
  json["at"] = PointJson(fault.at);
}

Json PointJson(Point p) { return Json::array({Rounded(p.x), Rounded(p.y)}); }

Json PointsJson(std::span<const Point> points) {
  Json list = Json::array();
  for (const Point p : points) list.push_back(PointJson(p));
  return list;
}

}  // namespace tautline
