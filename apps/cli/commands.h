// The commands of the program: each adds itself to the command line and runs when it was called.
#ifndef APPS_CLI_COMMANDS_H_
#define APPS_CLI_COMMANDS_H_

#include <CLI/App.hpp>
#include <functional>

#include "tautline/base/error.h"

namespace tautline::cli {

/// Runs a command after its options were parsed: the exit status, or what is wrong with the input.
using Run = std::function<Expected<int>()>;

Run AddShow(CLI::App& app);
Run AddPlan(CLI::App& app);
Run AddClasses(CLI::App& app);
Run AddTaut(CLI::App& app);
Run AddReach(CLI::App& app);
Run AddManifold(CLI::App& app);
Run AddDrive(CLI::App& app);
Run AddFleet(CLI::App& app);
Run AddLearn(CLI::App& app);
Run AddWorkspace(CLI::App& app);

}  // namespace tautline::cli

#endif  // APPS_CLI_COMMANDS_H_
