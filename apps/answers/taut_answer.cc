#include "apps/answers/taut_answer.h"

#include <utility>
#include <vector>

#include "apps/answers/verification.h"
#include "tautline/planners/tether/explain.h"
#include "tautline/planners/tether/verify_plan.h"
#include "tautline/scene/check_tether.h"

namespace tautline {
namespace {

/// The taut curve, or why the cable cannot lie as it is said to.
struct Pulled {
  tl::expected<LaidCable, LaidCableFault> laid;
  TautPath taut;
  std::string reason;
  std::string explanation;
};

Pulled Pull(const TetherPlanner& planner, const Tether& tether) {
  auto laid = planner.FollowLaidCable(tether);
  if (!laid) {
    const LaidCableFault fault = laid.error();
    return {laid, {}, ToString(fault.obstruction), ExplainLaidCable(planner.space(), fault.obstruction, fault.at)};
  }
  TautPath taut = planner.TetherAlong(laid->socket, laid->walk);
  return {std::move(laid), std::move(taut), "", ""};
}

Json ToJson(const Pulled& pulled, const FreeSpace& space) {
  Json json;
  json["command"] = "taut";
  json["status"] = pulled.reason.empty() ? "solved" : "infeasible";
  if (!pulled.reason.empty()) {
    json["reason"] = pulled.reason;
    json["explanation"] = pulled.explanation;
    return json;
  }
  const JsonValues values(space);
  json["taut"] = values.Of(pulled.taut.points);
  json["length"] = pulled.taut.length;
  json["word"] = values.Of(pulled.taut.word);
  json["homology"] = Abelianize(pulled.taut.word, space.islands.size());
  json["obstacles"] = NamesOf(space);
  return json;
}

std::vector<std::string> Faults(const Pulled& pulled, const TetherPlanner& planner, const Tether& tether) {
  if (!pulled.laid) return BlockedFaults(planner, tether, pulled.laid.error().obstruction);
  std::vector<std::string> faults = LaidCableFaults(planner, tether, *pulled.laid, pulled.taut);
  for (std::string& fault : faults) fault.insert(0, "the taut curve ");
  return faults;
}

}  // namespace

Expected<TautAnswer> AnswerTaut(const Scene& scene, const TautQuestion& question) {
  if (const auto checked = RequireTether(scene); !checked) return tl::unexpected(checked.error());
  const Tether& tether = *scene.tether;
  if (!tether.laid) {
    return InvalidInput("the tether has no laid cable; add `laid: [[x, y], ...]`, base first, robot last", scene.path);
  }
  auto planner = TetherPlanner::Prepare(scene.world);
  if (!planner) return tl::unexpected(planner.error());
  TautAnswer answer{.planner = std::move(*planner)};
  Pulled pulled = Pull(answer.planner, tether);
  answer.json = ToJson(pulled, answer.planner.space().free_space());
  answer.status = pulled.reason.empty() ? kExitSolved : kExitInfeasible;
  if (MustVerify(question.verify)) {
    const int curves = pulled.laid ? 1 : 0;
    answer.verified_curves = ReportVerification(Faults(pulled, answer.planner, tether), curves, answer.json);
  }
  answer.taut = std::move(pulled.taut);
  answer.explanation = std::move(pulled.explanation);
  return answer;
}

}  // namespace tautline
