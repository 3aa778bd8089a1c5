// The options with which a preparation is kept and used again.
#ifndef APPS_CLI_PREPARED_OPTIONS_H_
#define APPS_CLI_PREPARED_OPTIONS_H_

#include <CLI/App.hpp>

#include "apps/answers/preparation.h"
#include "apps/cli/common_options.h"
#include "apps/cli/progress_bar.h"

namespace tautline::cli {

/// --prepared and --save-prepared of a command.
struct PreparedOptions {
  CLI::Option* read;
  CLI::Option* write;
};

/// Adds both to a command.
PreparedOptions AddPreparedOptions(CLI::App& command, CommonOptions& options);

/// The preparation that the options ask for, which tells `progress` how far it is. Errors: the file cannot be read, or
/// is larger than 1 GiB.
[[nodiscard]] Expected<Preparation> ReadPreparation(const CommonOptions& options, ProgressBar& progress);

}  // namespace tautline::cli

#endif  // APPS_CLI_PREPARED_OPTIONS_H_
