// Trainings with several seeds in several threads, kept in a folder as they go.
#ifndef APPS_CLI_TRAINING_SEEDS_H_
#define APPS_CLI_TRAINING_SEEDS_H_

#include <cstdint>
#include <memory>
#include <vector>

#include "apps/answers/learn_options.h"
#include "apps/cli/progress_bar.h"
#include "apps/cli/training_folder.h"
#include "tautline/planners/contact_free/training_run.h"

namespace tautline::cli {

/// What to train.
struct TrainingSeeds {
  const TetherEnv* env = nullptr;     ///< At its start.
  LearnOptions options;               ///< Of all; its seed is the first one.
  const Kernels* kernels = nullptr;   ///< With which to compute.
  int seeds = 1;                      ///< So many, one after the other.
  int threads = 1;                    ///< That train.
  std::int64_t checkpoint_every = 1;  ///< Steps between checkpoints, at least.
};

/// Runs all trainings to their ends, in the order of the seeds. Each goes on from its checkpoint, if it has one, and
/// leaves a checkpoint, curves, visits and its policy. Ctrl-C and its like stop all at their next episodes; after the
/// checkpoints the program ends as without them. Errors: of the folder, and of a checkpoint that does not fit.
[[nodiscard]] Expected<std::vector<std::unique_ptr<TrainingRun>>> RunTrainings(const TrainingSeeds& what,
                                                                               TrainingFolder& folder,
                                                                               ProgressBar& progress);

}  // namespace tautline::cli

#endif  // APPS_CLI_TRAINING_SEEDS_H_
