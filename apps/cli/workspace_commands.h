// The commands below `tautline workspace`; each adds itself to that command.
#ifndef APPS_CLI_WORKSPACE_COMMANDS_H_
#define APPS_CLI_WORKSPACE_COMMANDS_H_

#include "apps/cli/commands.h"

namespace tautline::cli {

Run AddWorkspaceBest(CLI::App& workspace);
Run AddWorkspaceBoundary(CLI::App& workspace);
Run AddWorkspaceMove(CLI::App& workspace);
Run AddWorkspacePose(CLI::App& workspace);
Run AddWorkspaceMerge(CLI::App& workspace);
Run AddWorkspacePlace(CLI::App& workspace);
Run AddWorkspaceTour(CLI::App& workspace);

}  // namespace tautline::cli

#endif  // APPS_CLI_WORKSPACE_COMMANDS_H_
