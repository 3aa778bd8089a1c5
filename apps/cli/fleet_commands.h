// The commands below `tautline fleet`; each adds itself to that command.
#ifndef APPS_CLI_FLEET_COMMANDS_H_
#define APPS_CLI_FLEET_COMMANDS_H_

#include "apps/cli/commands.h"

namespace tautline::cli {

Run AddFleetCheck(CLI::App& fleet);
Run AddFleetLayouts(CLI::App& fleet);
Run AddFleetPlan(CLI::App& fleet);
Run AddFleetSimulate(CLI::App& fleet);

}  // namespace tautline::cli

#endif  // APPS_CLI_FLEET_COMMANDS_H_
