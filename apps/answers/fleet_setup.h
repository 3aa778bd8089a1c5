// What all questions about a fleet start from.
#ifndef APPS_ANSWERS_FLEET_SETUP_H_
#define APPS_ANSWERS_FLEET_SETUP_H_

#include <optional>

#include "apps/answers/json_values.h"
#include "tautline/base/error.h"
#include "tautline/planners/fleet/layout.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// A scene's fleet, prepared.
struct FleetSetup {
  FleetGround ground;
  /// The layout of the cable lines, or why they cannot be cable lines; absent where no robot has one.
  std::optional<tl::expected<FleetLayout, CableLineFault>> layout;

  /// The name of a robot.
  const std::string& name(RobotId id) const { return ground.robot(id).name; }
};

/// Errors: those of FleetGround::Prepare; some robots have a cable line and others none.
[[nodiscard]] Expected<FleetSetup> SetUpFleet(const Scene& scene, const Watcher& watch = {});

/// As SetUpFleet. Errors besides: the robots have no cable lines.
[[nodiscard]] Expected<FleetSetup> SetUpFleetLayout(const Scene& scene, const Watcher& watch = {});

/// `reason` (cable_blocked, cable_bends_in_open, cable_not_taut), `explanation`, `robot` and `at`.
void AddCableLineFault(const FleetSetup& setup, const CableLineFault& fault, Json& json);

/// [x, y] and [[x, y], ...], metres, in whole nanometres up to 1e6.
Json PointJson(Point p);
Json PointsJson(std::span<const Point> points);

}  // namespace tautline

#endif  // APPS_ANSWERS_FLEET_SETUP_H_
