// Jobs in threads, kept in a file as they are finished.
#ifndef APPS_CLI_KEPT_JOBS_H_
#define APPS_CLI_KEPT_JOBS_H_

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/answers/part_file.h"
#include "apps/cli/in_order.h"
#include "apps/cli/output_file.h"
#include "apps/cli/progress_bar.h"
#include "tautline/scene/text_file.h"

namespace tautline::cli {

/// The text of a part's file. Errors: it cannot be read, or is larger than 1 GiB.
[[nodiscard]] inline Expected<std::string> ReadPartFile(const std::string& path) {
  constexpr std::size_t kMostBytes = std::size_t{1} << 30;
  return ReadTextFile(path, kMostBytes);
}

/// How jobs are run and kept.
struct KeptJobsOptions {
  std::size_t jobs = 0;         ///< Of the whole search.
  Shard shard = {};             ///< Those to run.
  int threads = 1;              ///< That run them.
  std::string checkpoint = {};  ///< A file to go on from and to keep finished jobs in; empty: none.
  std::string stage;            ///< Named by the progress bar.
};

/// A search in jobs of a type that has a number `job`.
template <class Job>
struct KeptJobs {
  std::function<Job(std::size_t job)> compute;  ///< Called from several threads at a time.
  /// The jobs of a part.
  std::function<Expected<std::vector<Job>>(std::string_view text, const std::string& name)> read;
  std::function<Json(const std::vector<Job>& done, bool complete)> write;  ///< A part.

  /// Runs the jobs of the shard that the checkpoint lacks, and returns all of the shard. The checkpoint is replaced as
  /// a whole at most once a second and at the end, so that whatever ends the program leaves a part that the next run
  /// goes on from. Errors: the checkpoint cannot be read or written, is no part, or belongs to another search or shard.
  [[nodiscard]] Expected<std::vector<Job>> Run(const KeptJobsOptions& options, ProgressBar& progress) const {
    auto done = ReadCheckpoint(options);
    if (!done) return done;
    std::vector<std::size_t> numbers;
    for (const Job& job : *done) numbers.push_back(job.job);
    const std::vector<std::size_t> left = JobsLeft(options.jobs, options.shard, numbers);
    // A file that cannot be written is found out before the work, not after it.
    Expected<void> kept = Keep(options, *done, left.empty());
    if (!kept) return tl::unexpected(kept.error());
    auto next = Clock::now() + std::chrono::seconds(1);
    const auto take = [&](std::size_t i, Job job) {
      done->push_back(std::move(job));
      progress.Tell(options.stage, static_cast<double>(i + 1) / static_cast<double>(left.size()));
      if (Clock::now() < next) return true;
      kept = Keep(options, *done, false);
      next = Clock::now() + std::chrono::seconds(1);
      return kept.has_value();
    };
    progress.Tell(options.stage, 0);
    InOrder<Job>::Run(
        {.count = left.size(), .threads = options.threads}, [&](std::size_t i) { return compute(left[i]); }, take);
    if (kept && !left.empty()) kept = Keep(options, *done, true);
    if (!kept) return tl::unexpected(kept.error());
    return done;
  }

 private:
  using Clock = std::chrono::steady_clock;

  /// The jobs that a checkpoint holds; none where there is no such file yet.
  Expected<std::vector<Job>> ReadCheckpoint(const KeptJobsOptions& options) const {
    std::error_code fault;  // What cannot be looked at cannot be written either, and that says why.
    if (options.checkpoint.empty() || !std::filesystem::exists(options.checkpoint, fault)) return {};
    const auto text = ReadPartFile(options.checkpoint);
    if (!text) return tl::unexpected(text.error());
    auto jobs = read(*text, options.checkpoint);
    if (!jobs) return jobs;
    for (const Job& job : *jobs) {
      if (options.shard.Has(job.job)) continue;
      return InvalidInput("holds job " + std::to_string(job.job) + " of another shard: give each shard its own file",
                          options.checkpoint);
    }
    return jobs;
  }

  Expected<void> Keep(const KeptJobsOptions& options, const std::vector<Job>& done, bool complete) const {
    if (options.checkpoint.empty()) return {};
    OutputFiles files;
    auto added = files.Add(options.checkpoint, write(done, complete).dump(1) + "\n");
    return added ? files.Commit() : added;
  }
};

}  // namespace tautline::cli

#endif  // APPS_CLI_KEPT_JOBS_H_
