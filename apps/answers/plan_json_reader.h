// A plan from the JSON that `fleet plan` prints.
#ifndef APPS_ANSWERS_PLAN_JSON_READER_H_
#define APPS_ANSWERS_PLAN_JSON_READER_H_

#include <string>
#include <vector>

#include "apps/answers/fleet_setup.h"
#include "tautline/planners/fleet/fleet_plan.h"

namespace tautline {

/// What a playback needs of a plan.
struct DrivenPlan {
  std::vector<RobotSchedule> schedule;  ///< By RobotId.
  std::vector<Passing> passings;        ///< Between the paths as driven.
};

/// Reads `schedule`, `passings` and `detour_passings` of a result of `fleet plan`. Errors: something is missing or of
/// the wrong kind, a robot is missing or unknown, a path is none for this fleet, times or places run backwards. `file`
/// is named in messages.
[[nodiscard]] Expected<DrivenPlan> ReadDrivenPlan(const FleetSetup& setup, const Json& json, const std::string& file);

}  // namespace tautline

#endif  // APPS_ANSWERS_PLAN_JSON_READER_H_
