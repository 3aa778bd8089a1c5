// `tautline workspace ...`: the commands about a robot that several cables move.
#include "apps/cli/commands.h"
#include "apps/cli/nested_commands.h"
#include "apps/cli/workspace_commands.h"

namespace tautline::cli {

Run AddWorkspace(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("workspace", "a robot moved by several cables");
  sub->footer(
      "Example:\n  tautline workspace boundary scenes/workspace.yaml --svg workspace.svg\n"
      "`tautline workspace COMMAND --help` tells more.");
  return AddNested(*sub, {AddWorkspaceBoundary, AddWorkspacePose, AddWorkspaceBest, AddWorkspaceMove, AddWorkspaceTour,
                          AddWorkspacePlace, AddWorkspaceMerge});
}

}  // namespace tautline::cli
