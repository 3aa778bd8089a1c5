#include "apps/answers/boundary_answer.h"

#include <utility>

#include "apps/answers/futures_json.h"
#include "apps/answers/verification.h"

namespace tautline {
namespace {

Expected<void> Carry(const Scene& scene, BoundaryAnswer& answer) {
  if (scene.futures.empty()) return {};
  auto futures = Futures::Prepare(scene.world, scene.cables->anchors, scene.futures);
  if (!futures) return tl::unexpected(futures.error());
  answer.futures = std::move(*futures);
  answer.outcomes = answer.futures->Carry(answer.setup.ground, answer.setup.anchors, *answer.boundary);
  answer.json.update(FuturesJson(*answer.futures, *answer.outcomes, true));
  answer.json["max_cable_lengths_over_futures"] = answer.outcomes->longest_cables;
  return {};
}

}  // namespace

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
  answer.json.update(BoundaryJson(answer.setup, *answer.boundary, answer.longest, values));
  if (const auto carried = Carry(scene, answer); !carried) return tl::unexpected(carried.error());
  if (MustVerify(question.verify)) {
    answer.verified_curves = ReportVerification(BoundaryFaults(answer.setup, *answer.boundary),
                                                static_cast<int>(answer.boundary->sides.size()), answer.json);
  }
  return answer;
}

}  // namespace tautline
