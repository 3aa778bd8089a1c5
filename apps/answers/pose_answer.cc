#include "apps/answers/pose_answer.h"

#include <utility>

#include "apps/answers/verification.h"
#include "tautline/homotopy/curve_faults.h"
#include "tautline/planners/cable_workspace/explain_workspace.h"

namespace tautline {
namespace {

std::string ToString(const Pose& pose) {
  if (pose.position == Containment::kInside) return "interior";
  return pose.touches_obstacle ? "boundary_touching" : "boundary_open";
}

void AddPose(const Pose& pose, const JsonValues& values, Json& json) {
  json["position"] = ToString(pose);
  json["spans"] = pose.spans;
  json["margin"] = pose.margin;
  json["largest_gap"] = pose.largest_gap;
  json["cables"] = Json::array();
  for (const PoseCable& cable : pose.cables) {
    Json entry = values.Of(cable.path, "taut");
    entry["length"] = cable.length;
    entry["direction"] = cable.direction ? Json::array({cable.direction->x, cable.direction->y}) : Json();
    json["cables"].push_back(std::move(entry));
  }
}

std::vector<std::string> Faults(const PoseAnswer& answer) {
  std::vector<std::string> faults = BoundaryFaults(answer.setup, *answer.boundary);
  for (const PoseCable& cable : answer.pose->cables) {
    for (const std::string& fault : CurveFaults(answer.setup.ground.space().free_space(), cable.path)) {
      faults.push_back("a cable " + fault);
    }
  }
  return faults;
}

void Look(const PoseQuestion& question, const JsonValues& values, PoseAnswer& answer) {
  const WorkspaceRegion region(answer.setup.ground, answer.setup.anchors, *answer.boundary);
  answer.pose = LookAtPose(region, answer.at);
  if (answer.pose->position == Containment::kOutside) {
    answer.explanation = ExplainOutside(*answer.boundary, "the pose", answer.at);
    answer.json["status"] = "infeasible";
    answer.json["reason"] = ToString(WorkspaceObstruction::kPoseOutside);
    answer.json["explanation"] = answer.explanation;
    answer.status = kExitInfeasible;
    return;
  }
  answer.json["status"] = "solved";
  AddPose(*answer.pose, values, answer.json);
  if (MustVerify(question.verify)) {
    const auto curves = static_cast<int>(answer.boundary->sides.size() + answer.pose->cables.size());
    answer.verified_curves = ReportVerification(Faults(answer), curves, answer.json);
  }
}

}  // namespace

Expected<PoseAnswer> AnswerPose(const Scene& scene, const PoseQuestion& question) {
  auto setup = SetUpWorkspace(scene);
  if (!setup) return tl::unexpected(setup.error());
  auto boundary = LayCables(scene, *setup);
  if (!boundary) return tl::unexpected(boundary.error());
  const auto at = RobotInWorkspace(scene, question.at, {.what = "the pose", .hint = "give the pose as --at X,Y"});
  if (!at) return tl::unexpected(at.error());
  PoseAnswer answer{.setup = std::move(*setup), .boundary = std::move(*boundary), .at = *at};
  const JsonValues values(answer.setup.ground.space().free_space());
  answer.json["command"] = "workspace pose";
  answer.json["status"] = "infeasible";
  if (answer.boundary) {
    answer.json["at"] = values.Of(answer.at);
    Look(question, values, answer);
  } else {
    answer.explanation = answer.boundary.error().explanation;
    AddFault(answer.setup, answer.boundary.error(), values, answer.json);
    answer.status = kExitInfeasible;
  }
  return answer;
}

}  // namespace tautline
