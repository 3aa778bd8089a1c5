#include "apps/answers/place_answer.h"

#include <utility>

#include "apps/answers/verification.h"
#include "apps/answers/workspace_setup.h"

namespace tautline {
namespace {

void AddPlacement(const PlaceSearch& search, const PlaceResult& result, Json& json) {
  const Placement& placement = *result.placement;
  const JsonValues values(search.ground.ground().space().free_space());
  json["anchors"] = Json::array();
  for (const Socket& anchor : placement.anchors) json["anchors"].push_back(values.Of(anchor.base));
  if (placement.worth.holds_all()) json["value"] = placement.worth.value;
  json["tasks_held"] = result.details.tasks_held;
  json["area"] = placement.boundary.area;
  if (result.details.futures) {
    json["expected_area"] = result.details.futures->expected_area;
    json["lost_probability"] = result.details.futures->lost_probability;
  }
  json["length"] = placement.boundary.length;
  json["boundary"] = values.Of(placement.boundary.ring);
  json["words"] = Json::array();
  for (const BoundarySide& side : placement.boundary.sides) json["words"].push_back(values.Of(side.path.word));
  json["max_cable_lengths"] = result.details.longest_cables;
}

Json HistoryJson(const std::vector<PlaceRecord>& history) {
  Json json = Json::array();
  for (const PlaceRecord& record : history) {
    json.push_back({{"job", record.job}, {"evaluations", record.evaluations}, {"best", record.best}});
  }
  return json;
}

Json ToJson(const PlaceSearch& search, const PlaceResult& result) {
  Json json;
  json["command"] = "workspace place";
  json["status"] = result.status == PlaceStatus::kSolved       ? "solved"
                   : result.status == PlaceStatus::kInfeasible ? "infeasible"
                                                               : "budget_exceeded";
  if (result.status != PlaceStatus::kSolved) {
    json["reason"] = ToString(result.obstruction);
    json["explanation"] = result.explanation;
  }
  json["objective"] = search.question.objective == PlaceObjective::kCable ? "cable" : "area";
  json["max_boundary"] = search.ground.max_boundary();
  if (result.placement) AddPlacement(search, result, json);
  json["jobs"] = search.question.jobs;
  json["jobs_done"] = result.jobs;
  json["seed"] = search.question.seed;
  json["evaluations"] = result.evaluations;
  json["incomplete_evaluations"] = result.incomplete;
  json["history"] = HistoryJson(result.history);
  return json;
}

}  // namespace

Expected<std::vector<PlaceJob>> JoinParts(const PlaceSearch& search, std::vector<NamedPart> parts, bool unfinished) {
  std::vector<PartNumbers> numbers;
  std::vector<PlaceJob> jobs;
  for (NamedPart& part : parts) {
    PartNumbers& of_part = numbers.emplace_back(PartNumbers{part.name, {}});
    for (PlaceJob& job : part.jobs) {
      of_part.jobs.push_back(job.job);
      jobs.push_back(std::move(job));
    }
  }
  if (auto checked = CheckParts(search.jobs(), numbers, unfinished); !checked) return tl::unexpected(checked.error());
  return jobs;
}

Expected<PlaceAnswer> AnswerPlace(const PlaceSearch& search, std::vector<PlaceJob> jobs, bool verify) {
  auto result = JoinPlaceJobs(search.ground, std::move(jobs));
  if (!result) return tl::unexpected(result.error());
  PlaceAnswer answer{.result = *std::move(result)};
  answer.json = ToJson(search, answer.result);
  if (answer.result.status != PlaceStatus::kSolved) answer.status = kExitInfeasible;
  if (MustVerify(verify) && answer.result.placement) {
    const WorkspaceBoundary& boundary = answer.result.placement->boundary;
    answer.verified_curves = ReportVerification(BoundaryFaults(search.ground.ground(), boundary),
                                                static_cast<int>(boundary.sides.size()), answer.json);
  }
  return answer;
}

}  // namespace tautline
