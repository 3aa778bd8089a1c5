// The commands below `tautline learn`; each adds itself to that command.
#ifndef APPS_CLI_LEARN_COMMANDS_H_
#define APPS_CLI_LEARN_COMMANDS_H_

#include "apps/cli/commands.h"

namespace tautline::cli {

Run AddLearnEvaluate(CLI::App& learn);
Run AddLearnReference(CLI::App& learn);
Run AddLearnTrain(CLI::App& learn);

}  // namespace tautline::cli

#endif  // APPS_CLI_LEARN_COMMANDS_H_
