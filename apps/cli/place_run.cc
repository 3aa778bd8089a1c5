#include "apps/cli/place_run.h"

#include <chrono>
#include <filesystem>
#include <utility>

#include "apps/cli/in_order.h"
#include "apps/cli/output_file.h"
#include "tautline/base/check.h"
#include "tautline/scene/text_file.h"

namespace tautline::cli {
namespace {

/// The jobs that a checkpoint holds; none where there is no such file yet.
Expected<std::vector<PlaceJob>> ReadCheckpoint(const PlaceSearch& search, const PlaceRun& run) {
  if (run.checkpoint.empty() || !std::filesystem::exists(run.checkpoint)) return {};
  const auto text = ReadPartFile(run.checkpoint);
  if (!text) return tl::unexpected(text.error());
  auto jobs = ReadPart(search, *text, run.checkpoint);
  if (!jobs) return jobs;
  for (const PlaceJob& job : *jobs) {
    if (run.shard.Has(job.job)) continue;
    return InvalidInput("holds job " + std::to_string(job.job) + " of another shard: give each shard its own file",
                        run.checkpoint);
  }
  return jobs;
}

/// Replaces a file now and then.
class Checkpoint {
 public:
  Checkpoint(const PlaceSearch& search, std::string path) : search_(search), path_(std::move(path)) {}

  /// Keeps the jobs if the last time was long ago.
  Expected<void> KeepSometimes(const std::vector<PlaceJob>& done) {
    if (Clock::now() < next_) return {};
    return Keep(done, false);
  }

  Expected<void> Keep(const std::vector<PlaceJob>& done, bool complete) {
    if (path_.empty()) return {};
    OutputFiles files;
    if (auto added = files.Add(path_, PartJson(search_, done, complete).dump(1) + "\n"); !added) return added;
    auto placed = files.Commit();
    next_ = Clock::now() + std::chrono::seconds(1);
    return placed;
  }

 private:
  using Clock = std::chrono::steady_clock;

  const PlaceSearch& search_;
  std::string path_;
  Clock::time_point next_ = Clock::now();
};

}  // namespace

Expected<std::vector<PlaceJob>> RunPlaceJobs(const PlaceSearch& search, const PlaceRun& run, ProgressBar& progress) {
  auto done = ReadCheckpoint(search, run);
  if (!done) return done;
  const std::vector<std::size_t> left = JobsLeft(search, run.shard, *done);
  const PlaceJobOptions options{.evaluations = search.question.evaluations, .seed = search.question.seed};
  Checkpoint checkpoint(search, run.checkpoint);
  // A file that cannot be written is found out before the work, not after it.
  if (auto kept = checkpoint.Keep(*done, left.empty()); !kept) return tl::unexpected(kept.error());
  Expected<void> kept;
  const auto compute = [&](std::size_t i) {
    auto job = RunPlaceJob(search.ground, options, left[i]);
    TAUTLINE_CHECK(job.has_value());
    return *std::move(job);
  };
  const auto take = [&](std::size_t i, PlaceJob job) {
    done->push_back(std::move(job));
    progress.Tell("places", static_cast<double>(i + 1) / static_cast<double>(left.size()));
    kept = checkpoint.KeepSometimes(*done);
    return kept.has_value();
  };
  progress.Tell("places", 0);
  InOrder<PlaceJob>::Run({.count = left.size(), .threads = run.threads}, compute, take);
  if (kept && !left.empty()) kept = checkpoint.Keep(*done, true);
  if (!kept) return tl::unexpected(kept.error());
  return done;
}

Expected<std::string> ReadPartFile(const std::string& path) {
  constexpr std::size_t kMostBytes = std::size_t{1} << 30;
  return ReadTextFile(path, kMostBytes);
}

}  // namespace tautline::cli
