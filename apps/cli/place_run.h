// The jobs of `tautline workspace place` in threads, kept in a file as they are finished.
#ifndef APPS_CLI_PLACE_RUN_H_
#define APPS_CLI_PLACE_RUN_H_

#include <string>
#include <vector>

#include "apps/answers/place_search.h"
#include "apps/cli/progress_bar.h"

namespace tautline::cli {

struct PlaceRun {
  int threads = 1;
  Shard shard = {};
  std::string checkpoint = {};  ///< A file to go on from and to keep finished jobs in; empty: none.
};

/// Runs the jobs of the shard as KeptJobs::Run does.
[[nodiscard]] Expected<std::vector<PlaceJob>> RunPlaceJobs(const PlaceSearch& search, const PlaceRun& run,
                                                           ProgressBar& progress);

}  // namespace tautline::cli

#endif  // APPS_CLI_PLACE_RUN_H_
