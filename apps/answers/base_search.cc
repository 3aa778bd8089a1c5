#include "apps/answers/base_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tautline/scene/check_tether.h"
#include "tautline/scene/number_text.h"
#include "tautline/scene/world_digest.h"

namespace tautline {
namespace {

/// Beyond these, a mistyped number would take all memory rather than be told.
constexpr std::size_t kMostCandidates = 1'000'000;

const char* NameOf(BaseObjective objective) { return objective == BaseObjective::kArea ? "area" : "deadlock"; }
const char* NameOf(BaseCandidates kind) { return kind == BaseCandidates::kLattice ? "lattice" : "walls"; }

double SpacingOf(const BaseQuestion& question, const CellGround& ground) {
  return question.spacing_m.value_or(
      std::max(ground.cell_m(), std::max(ground.columns(), ground.rows()) * ground.cell_m() / 20));
}

Json SearchJson(const Scene& scene, const BaseQuestion& question, const CellGround& ground) {
  return {{"length", scene.tether->length},
          {"resolution", ground.cell_m()},
          {"unknown_free", question.cells.unknown_free},
          {"connectivity", question.connectivity},
          {"objective", NameOf(question.objective)},
          {"candidates", NameOf(question.candidates)},
          {"spacing", SpacingOf(question, ground)},
          {"max_vertices", question.max_vertices},
          {"max_bytes", question.max_bytes}};
}

Json ToJson(const BaseTrial& trial) {
  return {
      {"job", trial.job},       {"cells", trial.cells}, {"vertices", trial.vertices}, {"deadlocks", trial.deadlocks},
      {"closed", trial.closed}, {"lost", trial.lost},   {"complete", trial.complete}};
}

BaseTrial TrialOf(const Json& json) {
  BaseTrial trial;
  trial.job = json.at("job").get<std::size_t>();
  trial.cells = json.at("cells").get<std::int64_t>();
  trial.vertices = json.at("vertices").get<std::int64_t>();
  trial.deadlocks = json.at("deadlocks").get<std::int64_t>();
  trial.closed = json.at("closed").get<std::int64_t>();
  trial.lost = json.at("lost").get<std::int64_t>();
  trial.complete = json.at("complete").get<bool>();
  return trial;
}

/// Whether a trial can be one of this search, as far as can be told without running it.
bool Fits(const BaseSearch& search, const BaseTrial& trial) {
  return trial.job < search.candidates.size() && trial.cells >= 1 && trial.cells <= trial.vertices && trial.lost >= 0 &&
         trial.lost <= trial.cells && trial.closed >= trial.lost && trial.closed <= trial.vertices &&
         trial.deadlocks >= 0;
}

Json AnswerJson(const BaseSearch& search, const BaseTrial& trial) {
  const double cell_area = search.ground.cell_m() * search.ground.cell_m();
  const Point at = search.ground.CentreOf(trial.base);
  Json json;
  json["base"] = Json::array({at.x, at.y});
  json["reached_area"] = static_cast<double>(trial.cells) * cell_area;
  json["vertices"] = trial.vertices;
  if (!search.trial.deadlocks) return json;
  json["deadlock_count"] = trial.deadlocks;
  json["deadlock_area"] = static_cast<double>(trial.closed) * cell_area;
  json["lost_area"] = static_cast<double>(trial.lost) * cell_area;
  return json;
}

}  // namespace

BaseTrial BaseSearch::Run(std::size_t job) const {
  BaseTrial result = TryBase(ground, candidates[job], trial);
  result.job = job;
  return result;
}

Expected<BaseSearch> PrepareBaseSearch(const Scene& scene, const BaseQuestion& question) {
  if (auto checked = RequireTether(scene); !checked) return tl::unexpected(checked.error());
  auto ground = MakeCellGround(scene.world, question.cells);
  if (!ground) return tl::unexpected(ground.error());
  const double cells = SpacingOf(question, *ground) / ground->cell_m();
  if (!(cells >= 0.5)) {
    return InvalidInput("must be at least half of a cell of " + Metres(ground->cell_m()), "--spacing");
  }
  const int most = std::max(ground->columns(), ground->rows());
  const int stride = static_cast<int>(std::lround(std::min<double>(cells, most)));
  std::vector<GridCell> candidates = CandidateBases(*ground, question.candidates, std::max(1, stride));
  if (candidates.size() > kMostCandidates) {
    return tl::unexpected(Error{ErrorCode::kLimitExceeded,
                                std::to_string(candidates.size()) + " candidates are too many: at most " +
                                    std::to_string(kMostCandidates) + "; give a larger --spacing",
                                "--best-base"});
  }
  PartKind part{.command = "manifold --best-base", .version = 1, .digest = WorldDigest(scene.world), .search = {}};
  part.search = SearchJson(scene, question, *ground);
  const BaseTrialOptions trial{.length_m = scene.tether->length,
                               .connectivity = question.connectivity == 4 ? Connectivity::kFour : Connectivity::kEight,
                               .deadlocks = question.objective == BaseObjective::kDeadlock,
                               .max_vertices = question.max_vertices,
                               .max_bytes = question.max_bytes};
  return BaseSearch{question, *std::move(ground), std::move(candidates), trial, std::move(part)};
}

Json BasePartJson(const BaseSearch& search, std::vector<BaseTrial> done, bool complete) {
  std::sort(done.begin(), done.end(), [](const BaseTrial& a, const BaseTrial& b) { return a.job < b.job; });
  Json jobs = Json::array();
  for (const BaseTrial& trial : done) jobs.push_back(ToJson(trial));
  return PartJson(search.part, std::move(jobs), complete);
}

Expected<std::vector<BaseTrial>> ReadBasePart(const BaseSearch& search, std::string_view text,
                                              const std::string& name) {
  const auto done = ReadPartJobs(search.part, text, name);
  if (!done) return tl::unexpected(done.error());
  auto trials = ReadingPart(search.part, name, [&done] {
    std::vector<BaseTrial> read;
    for (const Json& trial : *done) read.push_back(TrialOf(trial));
    return read;
  });
  if (!trials) return trials;
  for (BaseTrial& trial : *trials) {
    if (!Fits(search, trial)) {
      return InvalidInput("holds a job " + std::to_string(trial.job) +
                              " that cannot be one of this search: it was changed; run its shard again",
                          name);
    }
    trial.base = search.candidates[trial.job];
  }
  return trials;
}

BaseAnswer AnswerBases(const BaseSearch& search, std::vector<BaseTrial> trials) {
  BaseAnswer answer;
  answer.ranked = RankBases(trials, search.question.objective);
  answer.json["command"] = "manifold";
  answer.json["status"] = "solved";
  if (answer.ranked.empty()) {
    const bool none = search.candidates.empty();
    answer.explanation = none ? "no candidate lies on free ground: give a smaller --spacing or --resolution"
                              : "every candidate's manifold took more than --max-nodes or --max-bytes";
    answer.status = kExitInfeasible;
    answer.json["status"] = none ? "infeasible" : "budget_exceeded";
    answer.json["reason"] = none ? "start_blocked" : "budget_exceeded";
    answer.json["explanation"] = answer.explanation;
  }
  answer.json["objective"] = NameOf(search.question.objective);
  answer.json["resolution"] = search.ground.cell_m();
  answer.json["limit"] = search.trial.length_m;
  if (!answer.ranked.empty()) answer.json.update(AnswerJson(search, answer.ranked.front()));
  answer.json["jobs"] = search.candidates.size();
  answer.json["jobs_done"] = trials.size();
  answer.json["incomplete"] = trials.size() - answer.ranked.size();
  answer.json["candidates"] = Json::array();
  for (const BaseTrial& trial : answer.ranked) answer.json["candidates"].push_back(AnswerJson(search, trial));
  return answer;
}

}  // namespace tautline
