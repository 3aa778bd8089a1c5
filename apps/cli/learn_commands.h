// The commands below `tautline learn`; each adds itself to that command.
#ifndef APPS_CLI_LEARN_COMMANDS_H_
#define APPS_CLI_LEARN_COMMANDS_H_

#include "apps/cli/commands.h"

namespace tautline::cli {

Run AddLearnReference(CLI::App& learn);

}  // namespace tautline::cli

#endif  // APPS_CLI_LEARN_COMMANDS_H_
