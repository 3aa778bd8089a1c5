#include "apps/answers/plan_field_answer.h"

#include <cmath>
#include <utility>

#include "apps/answers/verification.h"
#include "tautline/planners/tether/explain.h"
#include "tautline/planners/tether/verify_plan.h"
#include "tautline/scene/check_tether.h"

namespace tautline {
namespace {

/// Plans again from the sample's tether, and checks that plan and that the sample says the same.
void Verify(const TetherPlanner& planner, const Scene& scene, const FieldSample& sample, CheckedRow& row) {
  constexpr int kSamples = 4;  // Along each motion; a field has thousands.
  const Tether tether{scene.tether->base, scene.tether->length, sample.tether.points};
  const PlanResult plan = planner.Plan(tether, *scene.goal);
  const Verification verification = VerifyPlan(planner, tether, *scene.goal, plan, {.samples = kSamples});
  row.faults.insert(row.faults.end(), verification.faults.begin(), verification.faults.end());
  row.curves += verification.curves;
  const bool agrees = plan.motion && std::fabs(plan.motion->path.length - sample.length) <= 1e-9 * sample.length &&
                      FirstHeading(plan.motion->path.points) == sample.heading_rad;
  if (!agrees) row.faults.emplace_back("a sample of the field is not what a plan from there says");
}

Json ToJson(const FieldSample& sample, const JsonValues& values) {
  Json json;
  json["at"] = values.Of(sample.at);
  json["word"] = values.Of(sample.tether.word);
  json["tether"] = sample.tether.length;
  json["heading"] = nullptr;
  if (sample.heading_rad) json["heading"] = *sample.heading_rad;
  json["length"] = sample.length;
  return json;
}

Json ToJson(const PlanFieldAnswer& answer, Point goal) {
  const JsonValues values(answer.planner->space().free_space());
  Json json;
  json["command"] = "plan";
  if (answer.from_base.status == PlanStatus::kInfeasible) {
    json["status"] = "infeasible";
    json["reason"] = ToString(answer.from_base.obstruction);
    json["explanation"] = answer.from_base.explanation;
  } else {
    json["status"] = answer.complete ? "solved" : "budget_exceeded";
    if (!answer.complete) {
      json["reason"] = "budget_exceeded";
      json["explanation"] = "the search from some points stopped at its budget; they are missing";
    }
  }
  json["goal"] = values.Of(goal);
  json["limit"] = answer.from_base.limit;
  json["resolution"] = answer.grid.resolution;
  json["field"] = Json::array();
  for (const FieldSample& sample : answer.samples) json["field"].push_back(ToJson(sample, values));
  return json;
}

}  // namespace

std::vector<CheckedRow> RunRows(int rows, const std::function<CheckedRow(int row)>& compute) {
  std::vector<CheckedRow> all;
  all.reserve(static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row) all.push_back(compute(row));
  return all;
}

Expected<PlanFieldAnswer> AnswerPlanField(const Scene& scene, const PlanFieldQuestion& question) {
  if (const auto checked = RequireTetherAndGoal(scene); !checked) return tl::unexpected(checked.error());
  auto planner = PreparePlanner(scene, question.preparation);
  if (!planner) return tl::unexpected(planner.error());
  PlanFieldAnswer answer{.planner = std::make_unique<const TetherPlanner>(std::move(*planner))};
  const auto field = PlanField::Prepare(*answer.planner, *scene.tether, *scene.goal, question.options);
  if (!field) return tl::unexpected(field.error());
  answer.from_base = field->from_base();
  answer.grid = field->grid();
  const bool verify = MustVerify(question.verify);
  const auto compute = [&](int row) {
    CheckedRow checked{.row = field->Row(row)};
    if (!verify) return checked;
    for (const FieldSample& sample : checked.row.samples) Verify(*answer.planner, scene, sample, checked);
    return checked;
  };
  std::vector<std::string> faults;
  int curves = 0;
  for (CheckedRow& checked : question.run_rows(answer.grid.rows, compute)) {
    answer.complete = answer.complete && checked.row.complete;
    for (FieldSample& sample : checked.row.samples) answer.samples.push_back(std::move(sample));
    faults.insert(faults.end(), checked.faults.begin(), checked.faults.end());
    curves += checked.curves;
  }
  const bool solved = answer.from_base.status != PlanStatus::kInfeasible && answer.complete;
  answer.status = solved ? kExitSolved : kExitInfeasible;
  answer.json = ToJson(answer, *scene.goal);
  if (verify) answer.verified_curves = ReportVerification(faults, curves, answer.json);
  return answer;
}

}  // namespace tautline
