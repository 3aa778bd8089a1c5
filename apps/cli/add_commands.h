// The whole command line of the program: for the program itself, and for what is made from its options.
#ifndef APPS_CLI_ADD_COMMANDS_H_
#define APPS_CLI_ADD_COMMANDS_H_

#include <CLI/App.hpp>

#include "apps/cli/commands.h"

namespace tautline::cli {

/// Names and describes the program and adds all of its commands to `app`, which is empty. Returns what runs the
/// one that is called.
Run AddCommands(CLI::App& app);

}  // namespace tautline::cli

#endif  // APPS_CLI_ADD_COMMANDS_H_
