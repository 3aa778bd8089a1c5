#include "apps/cli/prepared_options.h"

#include <utility>

#include "apps/cli/option_checks.h"
#include "tautline/scene/text_file.h"

namespace tautline::cli {

PreparedOptions AddPreparedOptions(CLI::App& command, CommonOptions& options) {
  CLI::Option* read = command.add_option("--prepared", options.prepared,
                                         "use the preparation of this world that --save-prepared wrote");
  read->type_name("FILE")->check(FileName());
  CLI::Option* write =
      command.add_option("--save-prepared", options.save_prepared, "keep the preparation of this world in this file");
  write->type_name("FILE")->check(FileName());
  return {read, write};
}

Expected<Preparation> ReadPreparation(const CommonOptions& options, ProgressBar& progress) {
  constexpr std::size_t kMostBytes = std::size_t{1} << 30;
  Preparation preparation{.watch = progress.watcher()};
  if (options.prepared.empty()) return preparation;
  progress.Tell("reading", std::nullopt);
  auto bytes = ReadTextFile(options.prepared, kMostBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  preparation.prepared = std::move(*bytes);
  preparation.path = options.prepared;
  return preparation;
}

}  // namespace tautline::cli
