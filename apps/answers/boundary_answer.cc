#include "apps/answers/boundary_answer.h"

#include <utility>

#include "apps/answers/verification.h"

namespace tautline {

Expected<BoundaryAnswer> AnswerBoundary(const Scene& scene, const BoundaryQuestion& question) {
  auto setup = SetUpWorkspace(scene);
  if (!setup) return tl::unexpected(setup.error());
  auto boundary = LayCables(scene, *setup);
  if (!boundary) return tl::unexpected(boundary.error());
  BoundaryAnswer answer{.setup = std::move(*setup), .boundary = std::move(*boundary)};
  const JsonValues values(answer.setup.ground.space().free_space());
  answer.json["command"] = "workspace boundary";
  answer.json["status"] = answer.boundary ? "solved" : "infeasible";
  if (!answer.boundary) {
    AddFault(answer.setup, answer.boundary.error(), values, answer.json);
    answer.status = kExitInfeasible;
    return answer;
  }
  answer.longest = LongestCables(answer.setup.ground, answer.setup.anchors, *answer.boundary);
  answer.json.update(BoundaryJson(answer.setup, *answer.boundary, values));
  if (MustVerify(question.verify)) {
    answer.verified_curves = ReportVerification(BoundaryFaults(answer.setup, *answer.boundary),
                                                static_cast<int>(answer.boundary->sides.size()), answer.json);
  }
  return answer;
}

}  // namespace tautline
