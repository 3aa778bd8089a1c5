// `tautline taut`: the laid cable pulled tight.
#include <fmt/format.h>

#include <memory>

#include "apps/answers/taut_answer.h"
#include "apps/cli/commands.h"
#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "tautline/draw/draw_taut.h"
#include "tautline/scene/number_text.h"

namespace tautline::cli {
namespace {

std::string ToText(const TautAnswer& answer, const Tether& tether) {
  if (answer.status != kExitSolved) return fmt::format("Not taut: {}.\n", answer.explanation);
  const FreeSpace& space = answer.planner.space().free_space();
  const TautPath& taut = answer.taut;
  std::string text = fmt::format("Taut: {} (as laid {}), class {}.\n", Metres(taut.length),
                                 Metres(Length(*tether.laid)), Describe(taut.word, NamesOf(space)));
  text += fmt::format("  taut     {}\n", Describe(taut.points));
  const std::vector<int> homology = Abelianize(taut.word, space.islands.size());
  for (std::size_t i = 0; i < homology.size(); ++i) {
    if (homology[i] != 0) text += fmt::format("  homology {} {:+}\n", space.islands[i].name, homology[i]);
  }
  return text + DescribeVerification(answer.verified_curves);
}

Expected<int> RunTaut(const CommonOptions& options) {
  const auto scene = ReadScene(options);
  if (!scene) return tl::unexpected(scene.error());
  const auto answer = AnswerTaut(*scene, {.verify = options.verify});
  if (!answer) return tl::unexpected(answer.error());
  const auto draw = [&] {
    const FreeSpace& space = answer->planner.space().free_space();
    return DrawTaut(*scene, space, {.laid = *scene->tether->laid, .taut = answer->taut});
  };
  const std::string text = ToText(*answer, *scene->tether);
  return Deliver(options, {.json = answer->json, .text = text, .draw = draw, .status = answer->status});
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
