// The question of `fleet plan`, answered: what every face of tautline hands out.
#ifndef APPS_ANSWERS_FLEET_PLAN_ANSWER_H_
#define APPS_ANSWERS_FLEET_PLAN_ANSWER_H_

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "apps/answers/exit_status.h"
#include "apps/answers/fleet_setup.h"
#include "tautline/planners/fleet/choose_layout.h"
#include "tautline/planners/fleet/plan_fleet.h"
#include "tautline/planners/fleet/playback.h"

namespace tautline {

struct FleetPlanQuestion {
  FleetPlanOptions options = {};                 ///< How the robots move.
  PlaybackOptions playback = {};                 ///< How the plan is played back.
  std::int64_t budget = ChooseOptions().budget;  ///< See ChooseOptions; where the scene has no cable lines.
};

/// A plan that its playback contradicts: a fault of tautline's own.
class FleetPlanContradicted : public std::logic_error {
 public:
  FleetPlanContradicted(const std::string& what, Json report) : std::logic_error(what), report_(std::move(report)) {}

  /// The scene and the plan, as they reproduce it.
  const Json& report() const { return report_; }

 private:
  Json report_;
};

struct FleetPlanAnswer {
  FleetSetup setup;
  std::optional<FleetPlan> plan = {};       ///< Nothing where there is none.
  std::optional<Playback> played = {};      ///< What came of it.
  std::optional<ChosenLayout> chosen = {};  ///< Where the scene has no cable lines.
  std::string explanation = {};             ///< Why there is none; empty when there is one.
  Json json = {};                           ///< The result as docs/fleet_plan.md describes it.
  ExitStatus status = kExitSolved;

  /// The layout that is to come out. Requires a plan.
  const FleetLayout& layout() const { return **setup.layout; }
};

/// Plans the motion to the layout of the scene's cable lines, or where it has none, to the one that takes the least
/// time. Errors: as SetUpFleet; an option cannot be meant; the watcher said stop before there was a layout. Each plan
/// is played back; throws FleetPlanContradicted where it does not make the layout.
[[nodiscard]] Expected<FleetPlanAnswer> AnswerFleetPlan(const Scene& scene, const FleetPlanQuestion& question);

/// The events as a table with a line of titles: robot, event, passings (labels, separated by spaces), x, y, along,
/// arrival, departure, speed. Requires a plan.
std::string FleetPlanCsv(const FleetPlanAnswer& answer);

}  // namespace tautline

#endif  // APPS_ANSWERS_FLEET_PLAN_ANSWER_H_
