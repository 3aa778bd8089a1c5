#include "apps/cli/place_run.h"

#include <utility>

#include "apps/cli/kept_jobs.h"
#include "tautline/base/check.h"

namespace tautline::cli {

Expected<std::vector<PlaceJob>> RunPlaceJobs(const PlaceSearch& search, const PlaceRun& run, ProgressBar& progress) {
  const PlaceJobOptions options{.evaluations = search.question.evaluations, .seed = search.question.seed};
  const KeptJobs<PlaceJob> jobs{
      .compute =
          [&](std::size_t number) {
            auto job = RunPlaceJob(search.ground, options, number);
            TAUTLINE_CHECK(job.has_value());
            return *std::move(job);
          },
      .read = [&](std::string_view text, const std::string& name) { return ReadPart(search, text, name); },
      .write = [&](const std::vector<PlaceJob>& done, bool complete) { return PartJson(search, done, complete); }};
  return jobs.Run({.jobs = search.jobs(),
                   .shard = run.shard,
                   .threads = run.threads,
                   .checkpoint = run.checkpoint,
                   .stage = "places"},
                  progress);
}

}  // namespace tautline::cli
