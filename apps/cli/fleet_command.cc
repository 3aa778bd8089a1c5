// `tautline fleet ...`: the commands about several tethered robots.
#include "apps/cli/commands.h"
#include "apps/cli/fleet_commands.h"
#include "apps/cli/nested_commands.h"

namespace tautline::cli {

Run AddFleet(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("fleet", "several tethered robots");
  sub->footer(
      "Example:\n  tautline fleet check scenes/fleet.yaml --svg layout.svg\n"
      "`tautline fleet COMMAND --help` tells more.");
  return AddNested(*sub, {AddFleetCheck, AddFleetLayouts, AddFleetPlan, AddFleetSimulate});
}

}  // namespace tautline::cli
