#include "apps/cli/training_seeds.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <numeric>
#include <string>
#include <utility>

#include "apps/answers/learn_answer.h"
#include "apps/cli/in_order.h"
#include "apps/cli/signals_blocked.h"

namespace tautline::cli {
namespace {

/// Episodes whose mean return is shown.
constexpr std::size_t kShownEpisodes = 20;

/// Whether a signal waits that will end the program. Requires that it is blocked.
bool MustStop() {
  sigset_t pending;
  sigpending(&pending);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (sigismember(&pending, signal) == 1) return true;
  }
  return false;
}

/// "return 45.2, at the goal 3 of 12 times".
std::string RemarkOf(const TrainingRun& run) {
  const auto& episodes = run.episodes();
  const std::size_t shown = std::min(kShownEpisodes, episodes.size());
  if (shown == 0) return "";
  double sum = 0;
  for (std::size_t i = episodes.size() - shown; i < episodes.size(); ++i) sum += episodes[i].totals.reward;
  const auto& tries = run.evaluations();
  const auto reached = std::count_if(tries.begin(), tries.end(),
                                     [](const EpisodeRecord& evaluation) { return evaluation.totals.success; });
  return fmt::format("return {:.1f}, at the goal {} of {} times", sum / static_cast<double>(shown), reached,
                     tries.size());
}

/// What the threads have in common.
class Trainer {
 public:
  Trainer(const TrainingSeeds& what, TrainingFolder& folder, ProgressBar& progress)
      : what_(what), folder_(folder), progress_(progress) {}

  Expected<std::unique_ptr<TrainingRun>> Train(std::size_t index) {
    LearnOptions options = what_.options;
    options.training.seed += index;
    auto run = std::make_unique<TrainingRun>(*what_.env, options.training, *what_.kernels);
    if (const auto begun = GoOn(*run); !begun) return tl::unexpected(begun.error());
    std::int64_t kept = run->steps();
    done_ += kept;
    while (!run->done() && !stop_) {
      const std::int64_t before = run->steps();
      run->RunEpisode();
      done_ += run->steps() - before;
      Show(*run);
      if (MustStop()) stop_ = true;
      if (!stop_ && run->steps() < kept + what_.checkpoint_every) continue;
      kept = run->steps();
      if (const auto saved = KeepState(*run); !saved) return tl::unexpected(saved.error());
    }
    const auto written = run->done() ? KeepResult(*run, options) : Expected<void>();
    if (!written) return tl::unexpected(written.error());
    return run;
  }

 private:
  Expected<void> GoOn(TrainingRun& run) {
    const std::uint64_t seed = run.options().seed;
    const auto bytes = folder_.Checkpoint(seed);
    if (!bytes) return tl::unexpected(bytes.error());
    if (!*bytes) return {};
    return run.Load(**bytes, folder_.PathOf(TrainingFolder::Of(seed, "checkpoint")));
  }

  Expected<void> KeepState(const TrainingRun& run) {
    return folder_.Write({{TrainingFolder::Of(run.options().seed, "checkpoint"), run.Save()}});
  }

  Expected<void> KeepResult(const TrainingRun& run, const LearnOptions& options) {
    const auto name = [&run](const char* file) { return TrainingFolder::Of(run.options().seed, file); };
    return folder_.Write({{name("episodes.csv"), EpisodesCsv(run.episodes())},
                          {name("evaluations.csv"), EpisodesCsv(run.evaluations())},
                          {name("visits.csv"), VisitsCsv(run.visits())},
                          {name("policy.onnx"), WriteOnnx(PolicyOf(run, options, *what_.kernels))},
                          {name("checkpoint"), run.Save()}});
  }

  void Show(const TrainingRun& run) {
    const double all = static_cast<double>(what_.options.training.dqn.steps) * what_.seeds;
    progress_.Tell("training", static_cast<double>(done_) / all);
    progress_.Remark(RemarkOf(run));
  }

  const TrainingSeeds& what_;
  TrainingFolder& folder_;
  ProgressBar& progress_;
  std::atomic<std::int64_t> done_ = 0;  ///< Steps of all seeds.
  std::atomic<bool> stop_ = false;
};

}  // namespace

Expected<std::vector<std::unique_ptr<TrainingRun>>> RunTrainings(const TrainingSeeds& what, TrainingFolder& folder,
                                                                 ProgressBar& progress) {
  using Trained = Expected<std::unique_ptr<TrainingRun>>;
  // Where it goes out of scope, a signal that waits ends the program.
  const SignalsBlocked blocked({SIGINT, SIGTERM, SIGHUP});
  Trainer trainer(what, folder, progress);
  std::vector<std::unique_ptr<TrainingRun>> runs;
  Expected<void> fault;
  InOrder<Trained>::Run(
      {.count = static_cast<std::size_t>(what.seeds), .threads = what.threads},
      [&trainer](std::size_t i) { return trainer.Train(i); },
      [&](std::size_t, Trained run) {
        if (!run) {
          fault = tl::unexpected(run.error());
          return false;
        }
        runs.push_back(*std::move(run));
        return true;
      });
  progress.Remark("");
  progress.Clear();
  if (!fault) return tl::unexpected(fault.error());
  return runs;
}

}  // namespace tautline::cli
