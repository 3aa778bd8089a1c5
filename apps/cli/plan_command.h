// What `tautline plan` was asked.
#ifndef APPS_CLI_PLAN_COMMAND_H_
#define APPS_CLI_PLAN_COMMAND_H_

#include <cstdint>
#include <optional>
#include <string>

#include "apps/cli/common_options.h"
#include "tautline/planners/contact_free/plan_contact_free.h"
#include "tautline/planners/tether/plan.h"

namespace tautline::cli {

struct PlanCommand {
  CommonOptions common;
  PlanOptions options;
  std::string goals;                 ///< A file of goals, or `-`; empty: the one of the scene.
  bool field = false;                ///< From everywhere instead of from the robot.
  std::optional<double> resolution;  ///< Of the field, metres.
  std::int64_t field_classes = 1;
  bool contact_free = false;           ///< With a simulated cable that is to touch nothing.
  std::optional<double> robot_radius;  ///< Instead of the scene's, metres.
  ContactFreeOptions contact_free_options;
};

/// Answers `plan --goals`: one line of JSON for each goal. The exit status, or what is wrong with the input.
[[nodiscard]] Expected<int> RunPlanGoals(const PlanCommand& command);

/// Answers `plan --contact-free`.
[[nodiscard]] Expected<int> RunPlanContactFree(const PlanCommand& command);

/// Answers `plan --field`.
[[nodiscard]] Expected<int> RunPlanField(const PlanCommand& command);

}  // namespace tautline::cli

#endif  // APPS_CLI_PLAN_COMMAND_H_
