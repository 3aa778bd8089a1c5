#include "apps/answers/reach_answer.h"

#include <string>
#include <utility>
#include <vector>

#include "apps/answers/verification.h"
#include "tautline/planners/tether/verify_reach.h"
#include "tautline/scene/check_tether.h"

namespace tautline {
namespace {

std::string StatusText(const ReachResult& result) {
  if (result.status == PlanStatus::kInfeasible) return "infeasible";
  return result.status == PlanStatus::kBudgetExceeded ? "budget_exceeded" : "solved";
}

std::string KindText(PieceKind kind) {
  return kind == PieceKind::kArc ? "arc" : kind == PieceKind::kCut ? "cut" : "wall";
}

Json ToJson(const JsonValues& values, const RegionPiece& piece) {
  Json json;
  json["kind"] = KindText(piece.kind);
  json["from"] = values.Of(piece.from);
  json["to"] = values.Of(piece.to);
  if (piece.is_arc()) {
    json["centre"] = values.Of(piece.centre);
    json["radius"] = piece.radius;
    json["sweep"] = piece.sweep;
    json["orientation"] = "counterclockwise";
  }
  return json;
}

Json ToJson(const JsonValues& values, const std::vector<RegionRing>& rings) {
  Json list = Json::array();
  for (const RegionRing& ring : rings) {
    Json& json = list.emplace_back();
    json["area"] = ring.area;
    json["pieces"] = Json::array();
    for (const RegionPiece& piece : ring.pieces) json["pieces"].push_back(ToJson(values, piece));
  }
  return list;
}

Json ToJson(const JsonValues& values, const ReachPoint& at) {
  Json json;
  json["point"] = values.Of(at.point);
  json["reachable"] = at.obstruction == PlanObstruction::kNone;
  if (at.obstruction != PlanObstruction::kNone) {
    json["reason"] = ToString(at.obstruction);
    json["explanation"] = at.explanation;
  }
  if (at.least_tether) json["least_tether"] = values.Of(*at.least_tether, "taut");
  if (at.classes) {
    json["classes"] = Json::array();
    for (const TautPath& path : at.classes->classes) json["classes"].push_back(values.Of(path, "taut"));
    json["complete"] = at.classes->complete;
  }
  return json;
}

void AddSheets(const SheetList& list, Json& json) {
  json["sheet_area"] = list.area;
  json["classes"] = list.classes;
  json["complete"] = list.complete;
  json["walks"] = list.walks;
}

void AddSheetRegions(const JsonValues& values, const SheetList& list, Json& json) {
  json["sheets"] = Json::array();
  for (const Sheet& sheet : list.sheets) {
    Json& one = json["sheets"].emplace_back();
    one["word"] = values.Of(sheet.word);
    one["area"] = sheet.area;
    one["region"] = ToJson(values, sheet.rings);
  }
}

Json ToJson(const ReachResult& result, const FreeSpace& space) {
  const JsonValues values(space);
  Json json;
  json["command"] = "reach";
  json["status"] = StatusText(result);
  if (result.status != PlanStatus::kSolved) {
    const bool infeasible = result.status == PlanStatus::kInfeasible;
    json["reason"] = infeasible ? ToString(result.obstruction) : "budget_exceeded";
    json["explanation"] = result.explanation;
  }
  json["limit"] = result.limit;
  if (result.status == PlanStatus::kInfeasible) return json;
  json["area"] = result.area;
  json["connected_area"] = result.connected_area;
  if (result.sheets) AddSheets(*result.sheets, json);
  if (result.at) json["at"] = ToJson(values, *result.at);
  if (result.stretched) json["stretched"] = values.Of(*result.stretched, "taut");
  json["regions"] = ToJson(values, result.regions);
  if (result.sheets && result.sheets->complete) AddSheetRegions(values, *result.sheets, json);
  return json;
}

}  // namespace

Expected<ReachAnswer> AnswerReach(const Scene& scene, const ReachQuestion& question) {
  if (const auto checked = RequireTether(scene); !checked) return tl::unexpected(checked.error());
  auto planner = PreparePlanner(scene, question.preparation);
  if (!planner) return tl::unexpected(planner.error());
  ReachAnswer answer{*std::move(planner), {}, {}};
  answer.result = Reach(answer.planner, *scene.tether, question.options);
  answer.json = ToJson(answer.result, answer.planner.space().free_space());
  if (answer.result.status != PlanStatus::kSolved) answer.status = kExitInfeasible;
  if (MustVerify(question.verify)) {
    const Verification verification = VerifyReach(answer.planner, *scene.tether, answer.result);
    answer.verified_curves = ReportVerification(verification.faults, verification.curves, answer.json);
  }
  return answer;
}

}  // namespace tautline
