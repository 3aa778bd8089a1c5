#include "apps/answers/best_answer.h"

#include <algorithm>
#include <utility>

#include "apps/answers/futures_json.h"
#include "apps/answers/verification.h"
#include "tautline/scene/check_tether.h"
#include "tautline/scene/number_fault.h"
#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

Expected<double> LimitOf(const Scene& scene, const BestQuestion& question) {
  const std::optional<double> limit = question.max_boundary ? question.max_boundary : scene.max_boundary;
  if (!limit) {
    return InvalidInput("there is no limit on the boundary; add `max_boundary: metres` or give --max-boundary",
                        scene.path);
  }
  if (const auto fault = PositiveFault(*limit)) {
    return tl::unexpected<Error>(Error{fault->code, "max_boundary" + fault->text, scene.path});
  }
  for (const Point task : scene.tasks) {
    if (const auto checked = CheckGoal(task, "a task"); !checked) return tl::unexpected(checked.error());
  }
  return *limit;
}

/// Keeps the best `most`. With futures, the best expectation comes first; equal ones stay in their order.
void Rank(std::vector<WorkspaceBoundary> boundaries, std::size_t most, BestAnswer& answer) {
  for (WorkspaceBoundary& boundary : boundaries) {
    answer.ranked.push_back({.boundary = std::move(boundary), .futures = {}});
  }
  if (!answer.futures) {
    if (answer.ranked.size() > most) answer.ranked.resize(most);
    return;
  }
  BoundaryCarrier carrier(*answer.futures, answer.setup.ground, answer.setup.anchors);
  for (RankedBoundary& ranked : answer.ranked) {
    ranked.futures = carrier.Carry(ranked.boundary, {.longest_cables = false});
  }
  const auto expected = [](const RankedBoundary& ranked) { return ranked.futures ? ranked.futures->expected_area : 0; };
  std::stable_sort(answer.ranked.begin(), answer.ranked.end(),
                   [&](const RankedBoundary& a, const RankedBoundary& b) { return expected(a) > expected(b); });
  if (answer.ranked.size() > most) answer.ranked.resize(most);
  for (RankedBoundary& ranked : answer.ranked) ranked.futures = carrier.Carry(ranked.boundary);
}

void Explain(const Scene& scene, const BoundaryList& list, BestAnswer& answer) {
  const std::string limit = Metres(answer.max_boundary);
  if (!list.complete) {
    answer.explanation =
        "the search stopped at its budget: boundaries may be missing; raise --budget or lower the limit";
  } else if (answer.ranked.empty()) {
    const bool apart = list.obstruction == WorkspaceObstruction::kAnchorsUnconnected;
    answer.explanation = apart                 ? "no free ground connects the anchors"
                         : scene.tasks.empty() ? "no valid boundary is within " + limit
                                               : "no valid boundary within " + limit + " holds all tasks";
  }
}

Json RankedJson(const BestAnswer& answer, const RankedBoundary& ranked, const JsonValues& values) {
  const auto longest = LongestCables(answer.setup.ground, answer.setup.anchors, ranked.boundary);
  Json json = BoundaryJson(answer.setup, ranked.boundary, longest, values);
  json.erase("sides");
  if (!ranked.futures) return json;
  json.update(FuturesJson(*answer.futures, *ranked.futures, false));
  json["max_cable_lengths_over_futures"] = ranked.futures->longest_cables;
  return json;
}

void Print(const BestQuestion& question, const BoundaryList& list, BestAnswer& answer) {
  const JsonValues values(answer.setup.ground.space().free_space());
  Json& json = answer.json;
  const bool stopped = !list.complete;
  json["command"] = "workspace best";
  json["status"] = stopped ? "budget_exceeded" : answer.ranked.empty() ? "infeasible" : "solved";
  if (stopped || answer.ranked.empty()) {
    json["reason"] =
        stopped ? "budget_exceeded" : ToString(list.obstruction.value_or(WorkspaceObstruction::kNoBoundary));
    json["explanation"] = answer.explanation;
  }
  json["max_boundary"] = answer.max_boundary;
  json["found"] = answer.found;
  json["complete"] = answer.complete;
  if (!answer.complete) json["complete_to"] = list.complete_length;
  json["boundaries"] = Json::array();
  for (const RankedBoundary& ranked : answer.ranked) json["boundaries"].push_back(RankedJson(answer, ranked, values));
  if (!question.longer_to) return;
  const BoundaryList longer = FindBoundaries(
      answer.setup.ground, answer.setup.anchors,
      {.max_boundary = *question.longer_to, .tasks = {}, .budget = question.budget, .keep_going = question.keep_going});
  const auto beyond = std::count_if(longer.boundaries.begin(), longer.boundaries.end(),
                                    [&](const WorkspaceBoundary& b) { return b.length > answer.max_boundary; });
  json["longer"] = {{"up_to", *question.longer_to}, {"count", beyond}, {"complete", longer.complete}};
}

}  // namespace

Expected<BestAnswer> AnswerBest(const Scene& scene, const BestQuestion& question) {
  const auto limit = LimitOf(scene, question);
  auto setup = SetUpWorkspace(scene, question.watch);
  if (!setup) return tl::unexpected(setup.error());
  if (!limit) return tl::unexpected(limit.error());
  BestAnswer answer{.setup = std::move(*setup), .max_boundary = *limit};
  if (!scene.futures.empty()) {
    auto futures = Futures::Prepare(scene.world, scene.cables->anchors, scene.futures, question.watch);
    if (!futures) return tl::unexpected(futures.error());
    answer.futures = std::move(*futures);
  }
  BoundaryList list = FindBoundaries(
      answer.setup.ground, answer.setup.anchors,
      {.max_boundary = *limit, .tasks = scene.tasks, .budget = question.budget, .keep_going = question.keep_going});
  answer.found = list.boundaries.size();
  answer.complete = list.complete;
  const auto most = static_cast<std::size_t>(question.count.value_or(static_cast<std::int64_t>(answer.found)));
  Rank(std::move(list.boundaries), most, answer);
  Explain(scene, list, answer);
  Print(question, list, answer);
  answer.status = list.complete && !answer.ranked.empty() ? kExitSolved : kExitInfeasible;
  if (MustVerify(question.verify)) {
    std::vector<std::string> faults;
    int curves = 0;
    for (const RankedBoundary& ranked : answer.ranked) {
      for (std::string& fault : BoundaryFaults(answer.setup, ranked.boundary)) faults.push_back(std::move(fault));
      curves += static_cast<int>(ranked.boundary.sides.size());
    }
    answer.verified_curves = ReportVerification(faults, curves, answer.json);
  }
  return answer;
}

}  // namespace tautline
