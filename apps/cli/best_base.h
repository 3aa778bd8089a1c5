// `tautline manifold --best-base`.
#ifndef APPS_CLI_BEST_BASE_H_
#define APPS_CLI_BEST_BASE_H_

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "apps/answers/base_search.h"
#include "apps/cli/common_options.h"

namespace tautline::cli {

struct BestBaseOptions {
  bool asked = false;
  std::string objective = "area";
  std::string candidates = "lattice";
  double spacing = 0;  ///< Metres; 0: the default.
  std::string shard;
  std::string checkpoint;
  std::vector<std::string> parts;
  bool unfinished = false;
};

/// Adds --best-base and what goes with it to a command.
void AddBestBaseOptions(CLI::App& command, BestBaseOptions& options);

/// Runs the search, or a shard of it, or joins parts, and hands out the answer. `question`: the cells, connectivity and
/// budgets that the command was given.
[[nodiscard]] Expected<int> RunBestBase(const CommonOptions& common, const BestBaseOptions& options,
                                        BaseQuestion question);

}  // namespace tautline::cli

#endif  // APPS_CLI_BEST_BASE_H_
