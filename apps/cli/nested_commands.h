// Commands of commands: `tautline workspace boundary`.
#ifndef APPS_CLI_NESTED_COMMANDS_H_
#define APPS_CLI_NESTED_COMMANDS_H_

#include <CLI/App.hpp>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "apps/cli/commands.h"

namespace tautline::cli {

/// Adds the commands below one, or below the program, that does nothing itself, and returns what runs the one that is
/// called.
Run AddNested(CLI::App& command, std::initializer_list<Run (*)(CLI::App&)> adders);

/// What is wrong with the names of the commands in a call, if anything: "there is no command 'plon'; there are ...".
/// `words` are those of the call after the program.
std::optional<std::string> UnknownCommand(const CLI::App& app, const std::vector<std::string>& words);

}  // namespace tautline::cli

#endif  // APPS_CLI_NESTED_COMMANDS_H_
