// `tautline taut`: the laid cable pulled tight.
#include <fmt/format.h>

#include <memory>

#include "apps/cli/commands.h"
#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/json_values.h"
#include "apps/cli/required_parts.h"
#include "apps/cli/verification.h"
#include "tautline/draw/draw_taut.h"
#include "tautline/planners/tether/explain.h"
#include "tautline/planners/tether/tether_planner.h"
#include "tautline/planners/tether/verify_plan.h"

namespace tautline::cli {
namespace {

/// The taut curve, or why the cable cannot lie as it is said to.
struct Pulled {
  TautPath taut;
  bool has_stub = false;
  std::string reason;
  std::string explanation;
};

Pulled Pull(const TetherPlanner& planner, const Tether& tether) {
  const auto laid = planner.FollowLaidCable(tether);
  if (!laid) {
    const LaidCableFault& fault = laid.error();
    return {{}, false, ToString(fault.obstruction), ExplainLaidCable(planner.space(), fault.obstruction, fault.at)};
  }
  return {planner.TetherAlong(laid->socket, laid->walk), laid->socket.stub_length > 0, "", ""};
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

std::string ToText(const Pulled& pulled, const FreeSpace& space, const Tether& tether) {
  if (!pulled.reason.empty()) return fmt::format("Not taut: {}.\n", pulled.explanation);
  std::string text = fmt::format("Taut: {} (as laid {}), class {}.\n", Metres(pulled.taut.length),
                                 Metres(Length(*tether.laid)), Describe(pulled.taut.word, NamesOf(space)));
  text += fmt::format("  taut     {}\n", Describe(pulled.taut.points));
  const std::vector<int> homology = Abelianize(pulled.taut.word, space.islands.size());
  for (std::size_t i = 0; i < homology.size(); ++i) {
    if (homology[i] != 0) text += fmt::format("  homology {} {:+}\n", space.islands[i].name, homology[i]);
  }
  return text;
}

Expected<int> RunTaut(const CommonOptions& options) {
  const auto scene = ReadScene(options);
  if (!scene) return tl::unexpected(scene.error());
  if (const auto missing = MissingTether(*scene)) return tl::unexpected(*missing);
  const Tether& tether = *scene->tether;
  if (!tether.laid) {
    return InvalidInput("the tether has no laid cable; add `laid: [[x, y], ...]`, base first, robot last", scene->path);
  }
  const auto planner = TetherPlanner::Prepare(scene->world);
  if (!planner) return tl::unexpected(planner.error());
  const Pulled pulled = Pull(*planner, tether);
  const FreeSpace& space = planner->space().free_space();
  Json json = ToJson(pulled, space);
  std::string text = ToText(pulled, space, tether);
  if (MustVerify(options) && pulled.reason.empty()) {
    std::vector<std::string> faults = CurveFaults(space, pulled.taut, pulled.has_stub);
    if (!pulled.has_stub && planner->space().rays().WordOf(*tether.laid) != pulled.taut.word) {
      faults.emplace_back("the taut curve is not in the class of the laid cable");
    }
    ReportVerification(faults, 1, json, text);
  }
  const auto draw = [&] { return DrawTaut(*scene, space, {.laid = *tether.laid, .taut = pulled.taut}); };
  const int status = pulled.reason.empty() ? kExitSolved : kExitInfeasible;
  return Deliver(options, {.json = json, .text = text, .draw = draw, .status = status});
}

}  // namespace

Run AddTaut(CLI::App& app) {
  const auto options = std::make_shared<CommonOptions>();
  CLI::App* sub = app.add_subcommand("taut", "the laid cable pulled tight, with its word and homology");
  AddCommonOptions(*sub, *options);
  sub->footer(
      "Example:\n  tautline taut scenes/two_ways.yaml --svg taut.svg\n"
      "Exit status: 0 solved, 2 bad input, 3 the cable crosses an obstacle.");
  return [options] { return RunTaut(*options); };
}

}  // namespace tautline::cli
