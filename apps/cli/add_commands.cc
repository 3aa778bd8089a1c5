#include "apps/cli/add_commands.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "apps/cli/nested_commands.h"

namespace tautline::cli {

Run AddCommands(CLI::App& app) {
  app.name("tautline");
  app.description("Plans for robots on a tether: exact shortest motions that the cable allows.");
  app.set_version_flag("--version", "tautline " TAUTLINE_VERSION);
  app.footer("Example:\n  tautline plan scenes/two_ways.yaml --svg plan.svg\n`tautline COMMAND --help` tells more.");
  return AddNested(
      app, {AddPlan, AddReach, AddManifold, AddDrive, AddClasses, AddTaut, AddShow, AddWorkspace, AddFleet, AddLearn});
}

}  // namespace tautline::cli
