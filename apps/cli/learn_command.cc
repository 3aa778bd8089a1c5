// `tautline learn ...`: the commands about paths that touch nothing.
#include "apps/cli/commands.h"
#include "apps/cli/learn_commands.h"
#include "apps/cli/nested_commands.h"

namespace tautline::cli {

Run AddLearn(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("learn", "paths on which cable, robot and obstacles touch as little as possible");
  sub->footer(
      "Example:\n  tautline learn train scenes/quiet_room.yaml --steps 60000 --out run\n"
      "`tautline learn COMMAND --help` tells more.");
  return AddNested(*sub, {AddLearnReference, AddLearnTrain, AddLearnEvaluate});
}

}  // namespace tautline::cli
