#include "apps/cli/add_commands.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace tautline::cli {

std::vector<Run> AddCommands(CLI::App& app) {
  app.name("tautline");
  app.description("Plans for robots on a tether: exact shortest motions that the cable allows.");
  app.set_version_flag("--version", "tautline " TAUTLINE_VERSION);
  app.require_subcommand(1);
  app.footer("Example:\n  tautline plan scenes/two_ways.yaml --svg plan.svg\n`tautline COMMAND --help` tells more.");
  std::vector<Run> runs;
  for (const auto add : {AddPlan, AddReach, AddClasses, AddTaut, AddShow, AddWorkspace}) runs.push_back(add(app));
  return runs;
}

}  // namespace tautline::cli
