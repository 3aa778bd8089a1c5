// `tautline learn ...`: the commands about paths that touch nothing.
#include "apps/cli/commands.h"
#include "apps/cli/learn_commands.h"
#include "apps/cli/nested_commands.h"

namespace tautline::cli {

Run AddLearn(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("learn", "paths on which robot and cable touch nothing");
  sub->footer(
      "Example:\n  tautline learn reference scenes/store_room.yaml --robot-radius 0.3 --svg reference.svg\n"
      "`tautline learn COMMAND --help` tells more.");
  return AddNested(*sub, {AddLearnReference});
}

}  // namespace tautline::cli
