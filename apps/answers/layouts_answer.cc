#include "apps/answers/layouts_answer.h"

#include <utility>

#include "apps/answers/verification.h"
#include "tautline/planners/fleet/check_layout.h"
#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

Json LayoutJson(const FleetSetup& setup, const FoundLayout& layout) {
  Json cables = Json::array();
  for (std::size_t i = 0; i < layout.routes.size(); ++i) {
    cables.push_back({{"robot", setup.name(RobotId(i))},
                      {"cable", PointsJson(PointsOf(setup.ground, layout.routes[i]))},
                      {"length", layout.lengths[i]}});
  }
  return {{"length", layout.total}, {"cables", std::move(cables)}};
}

void AddLayouts(const FleetSetup& setup, const LayoutsResult& result, Json& json) {
  json["layouts"] = Json::array();
  for (const FoundLayout& layout : result.layouts) json["layouts"].push_back(LayoutJson(setup, layout));
  json["count"] = result.layouts.size();
  json["complete"] = result.complete;
  if (!result.complete) json["complete_below"] = result.complete_below;
  if (result.count) json["all"] = *result.count;
  json["routes"] = result.routes;
}

/// Why a robot has no cable line, as a slug and a sentence.
std::pair<std::string, std::string> WhyNoLine(const FleetSetup& setup, RobotId id, bool limited) {
  const FleetRobot& robot = setup.ground.robot(id);
  const auto blocked = [&](Point p) { return setup.ground.space() != nullptr && !setup.ground.space()->Locate(p); };
  if (blocked(robot.start)) {
    return {"start_blocked", "the start of " + robot.name + ", " + ToText(robot.start) + ", is not in the free space"};
  }
  if (blocked(robot.target)) {
    return {"target_blocked",
            "the target of " + robot.name + ", " + ToText(robot.target) + ", is not in the free space"};
  }
  return {"no_cable_line", "robot " + robot.name + " has no cable line" +
                               (limited || robot.tether ? " up to the limit" : "") +
                               " that keeps all other starts outside of its polygon"};
}

/// Why there is no layout, as a slug and a sentence.
std::pair<std::string, std::string> WhyNone(const LayoutsAnswer& answer, const LayoutsOptions& options) {
  const LayoutsResult& result = answer.result;
  if (result.budget_exceeded)
    return {"budget_exceeded", "the budget ran out before a layout was found; raise --budget"};
  const bool limited = options.max_length || options.max_total;
  if (!result.without_route.empty()) return WhyNoLine(answer.setup, result.without_route[0], limited);
  return {"no_layout", limited ? "no layout up to the limit is free of crossings"
                               : "each layout crosses, loops or encloses a start"};
}

void Verify(LayoutsAnswer& answer) {
  std::vector<std::string> faults;
  int curves = 0;
  for (const FoundLayout& layout : answer.result.layouts) {
    if (!CheckLayout(answer.setup.ground, layout.routes).none()) faults.emplace_back("a layout fails the check");
    curves += static_cast<int>(layout.routes.size());
  }
  answer.verified_curves = ReportVerification(faults, curves, answer.json);
}

}  // namespace

Expected<LayoutsAnswer> AnswerLayouts(const Scene& scene, const LayoutsQuestion& question) {
  auto ground = FleetGround::Prepare(scene, question.options.watch);
  if (!ground) return tl::unexpected(ground.error());
  LayoutsAnswer answer{.setup = {*std::move(ground), std::nullopt}};
  answer.result = FindLayouts(answer.setup.ground, question.options);
  answer.json["command"] = "fleet layouts";
  const bool found = !answer.result.layouts.empty();
  const bool exceeded = answer.result.budget_exceeded;
  answer.json["status"] = exceeded ? "budget_exceeded" : found ? "solved" : "infeasible";
  if (!found) {
    const auto [reason, explanation] = WhyNone(answer, question.options);
    answer.json["reason"] = reason;
    answer.json["explanation"] = answer.explanation = explanation;
  }
  if (!found || exceeded) answer.status = kExitInfeasible;
  AddLayouts(answer.setup, answer.result, answer.json);
  if (found && MustVerify(question.verify)) Verify(answer);
  return answer;
}

}  // namespace tautline
