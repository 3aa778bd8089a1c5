#include "apps/answers/place_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tautline/scene/world_digest.h"

namespace tautline {
namespace {

PartKind KindOfPart() { return {.command = "workspace place", .version = 1, .digest = 0, .search = {}}; }

std::string ToString(PlaceObjective objective) { return objective == PlaceObjective::kCable ? "cable" : "area"; }

Json ToJson(const PlaceQuestion& question) {
  return {{"anchors", question.anchors},
          {"objective", ToString(question.objective)},
          {"max_boundary", question.max_boundary ? Json(*question.max_boundary) : Json()},
          {"budget", question.budget},
          {"jobs", question.jobs},
          {"evaluations", question.evaluations},
          {"seed", question.seed}};
}

PlaceQuestion QuestionOf(const Json& json) {
  PlaceQuestion question;
  question.anchors = json.at("anchors").get<std::size_t>();
  question.objective =
      json.at("objective").get<std::string>() == "cable" ? PlaceObjective::kCable : PlaceObjective::kArea;
  question.max_boundary = json.at("max_boundary").get<double>();
  question.budget = json.at("budget").get<std::int64_t>();
  question.jobs = json.at("jobs").get<std::size_t>();
  question.evaluations = json.at("evaluations").get<std::int64_t>();
  question.seed = json.at("seed").get<std::uint64_t>();
  return question;
}

Json ToJson(const PlaceJob& job) {
  Json gains = Json::array();
  for (const PlaceGain& gain : job.gains) {
    gains.push_back(Json::array({gain.evaluation, gain.worth.outside, gain.worth.value}));
  }
  return {{"job", job.job},
          {"start", job.start},
          {"positions", job.positions},
          {"gains", std::move(gains)},
          {"evaluations", job.evaluations},
          {"incomplete", job.incomplete}};
}

PlaceJob JobOf(const Json& json) {
  PlaceJob job;
  job.job = json.at("job").get<std::size_t>();
  job.start = json.at("start").get<std::vector<double>>();
  job.positions = json.at("positions").get<std::vector<double>>();
  for (const Json& gain : json.at("gains")) {
    job.gains.push_back({gain.at(0).get<std::int64_t>(), {gain.at(1).get<double>(), gain.at(2).get<double>()}});
  }
  job.evaluations = json.at("evaluations").get<std::int64_t>();
  job.incomplete = json.at("incomplete").get<std::int64_t>();
  return job;
}

PartKind KindOf(const PlaceSearch& search) {
  PartKind kind = KindOfPart();
  kind.digest = search.digest;
  kind.search = ToJson(search.question);
  return kind;
}

/// Beyond these, a mistyped number would take all memory rather than be told.
constexpr std::size_t kMostAnchors = 1000;
constexpr std::size_t kMostJobs = 1'000'000;

std::optional<Error> FaultOf(const PlaceQuestion& question) {
  const auto beyond = [](const std::string& where, std::size_t value, std::size_t most) {
    return Error{ErrorCode::kLimitExceeded, std::to_string(value) + " are too many: at most " + std::to_string(most),
                 where};
  };
  if (question.anchors > kMostAnchors) return beyond("anchors", question.anchors, kMostAnchors);
  if (question.jobs > kMostJobs) return beyond("jobs", question.jobs, kMostJobs);
  return std::nullopt;
}

bool Fits(const PlaceSearch& search, const std::vector<double>& positions) {
  const double length = search.ground.outline().length();
  return positions.size() == search.question.anchors && std::is_sorted(positions.begin(), positions.end()) &&
         std::all_of(positions.begin(), positions.end(), [length](double p) { return p >= 0 && p < length; });
}

/// Whether a job can be one of this search, as far as can be told without running it.
bool Fits(const PlaceSearch& search, const PlaceJob& job) {
  if (job.job >= search.question.jobs || !Fits(search, job.start)) return false;
  if (job.positions.empty() != job.gains.empty()) return false;
  if (!job.positions.empty() && !Fits(search, job.positions)) return false;
  std::int64_t last = 0;
  for (const PlaceGain& gain : job.gains) {
    if (gain.evaluation <= last || gain.worth.outside < 0) return false;
    last = gain.evaluation;
  }
  return last <= job.evaluations && job.evaluations <= search.question.evaluations && job.incomplete >= 0 &&
         job.incomplete <= job.evaluations;
}

}  // namespace

Expected<PlaceSearch> PreparePlaceSearch(const Scene& scene, const PlaceQuestion& question, const Watcher& watch) {
  if (const auto fault = FaultOf(question)) return tl::unexpected(*fault);
  const auto limit = question.max_boundary ? question.max_boundary : scene.max_boundary;
  auto ground = PlacementGround::Prepare(scene.world,
                                         {.anchors = question.anchors,
                                          .objective = question.objective,
                                          .max_boundary = limit,
                                          .tasks = scene.tasks,
                                          .futures = scene.futures,
                                          .budget = question.budget},
                                         watch);
  if (!ground) {
    if (ground.error().where.empty()) ground.error().where = scene.path;
    return tl::unexpected(ground.error());
  }
  PlaceSearch search{question, WorkspaceDigest(scene), *std::move(ground)};
  search.question.max_boundary = search.ground.max_boundary();
  return search;
}

Json PartJson(const PlaceSearch& search, std::vector<PlaceJob> done, bool complete) {
  std::sort(done.begin(), done.end(), [](const PlaceJob& a, const PlaceJob& b) { return a.job < b.job; });
  Json jobs = Json::array();
  for (const PlaceJob& job : done) jobs.push_back(ToJson(job));
  return PartJson(KindOf(search), std::move(jobs), complete);
}

Expected<PlaceQuestion> ReadPartQuestion(std::string_view text, const std::string& name) {
  const PartKind kind = KindOfPart();
  const auto json = ReadPartSearch(kind, text, name);
  if (!json) return tl::unexpected(json.error());
  return ReadingPart(kind, name, [&json] { return QuestionOf(*json); });
}

Expected<std::vector<PlaceJob>> ReadPart(const PlaceSearch& search, std::string_view text, const std::string& name) {
  const PartKind kind = KindOf(search);
  const auto done = ReadPartJobs(kind, text, name);
  if (!done) return tl::unexpected(done.error());
  auto jobs = ReadingPart(kind, name, [&done] {
    std::vector<PlaceJob> read;
    for (const Json& job : *done) read.push_back(JobOf(job));
    return read;
  });
  if (!jobs) return jobs;
  for (const PlaceJob& job : *jobs) {
    if (!Fits(search, job)) {
      return InvalidInput("holds a job " + std::to_string(job.job) +
                              " that cannot be one of this search: it was "
                              "changed; run its shard again",
                          name);
    }
  }
  return jobs;
}

}  // namespace tautline
