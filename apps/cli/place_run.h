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
  PlaceShard shard = {};
  std::string checkpoint = {};  ///< A file to go on from and to keep finished jobs in; empty: none.
};

/// Runs the jobs of the shard that the checkpoint lacks, and returns all of the shard. The checkpoint is replaced as a
/// whole at most once a second and at the end, so that whatever ends the program leaves a part that the next run goes
/// on from. Errors: the checkpoint cannot be read or written, is no part, or belongs to another search or shard.
[[nodiscard]] Expected<std::vector<PlaceJob>> RunPlaceJobs(const PlaceSearch& search, const PlaceRun& run,
                                                           ProgressBar& progress);

/// The text of a part's file. Errors: it cannot be read, or is larger than 1 GiB.
[[nodiscard]] Expected<std::string> ReadPartFile(const std::string& path);

}  // namespace tautline::cli

#endif  // APPS_CLI_PLACE_RUN_H_
