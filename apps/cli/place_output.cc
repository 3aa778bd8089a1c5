#include "apps/cli/place_output.h"

#include <fmt/format.h>

#include <utility>

#include "apps/cli/describe.h"
#include "tautline/draw/draw_place.h"
#include "tautline/scene/number_text.h"

namespace tautline::cli {
namespace {

/// "4 winches: 120 m² of workspace".
std::string Headline(const PlaceSearch& search, const PlaceResult& result) {
  const Placement& placement = *result.placement;
  const std::string winches = Counted(placement.anchors.size(), "winch", "winches");
  if (search.question.objective == PlaceObjective::kCable) {
    return fmt::format("{} hold all tasks with {} of cable", winches, Metres(placement.worth.value));
  }
  return fmt::format("{} move the robot in {}{}", winches, SquareMetres(placement.worth.value),
                     result.details.futures ? ", expected over all futures" : "");
}

std::string ToText(const PlaceSearch& search, const PlaceAnswer& answer) {
  const PlaceResult& result = answer.result;
  std::string text;
  if (result.status != PlaceStatus::kSolved) {
    text += fmt::format("No place: {}.\n", result.explanation);
  } else {
    text += fmt::format("Best places found: {}.\n", Headline(search, result));
  }
  if (result.placement) {
    const Placement& placement = *result.placement;
    const std::vector<std::string> names = NamesOf(search.ground.ground().space().free_space());
    for (std::size_t i = 0; i < placement.anchors.size(); ++i) {
      text += fmt::format("  winch {:<2}  {:<20}  needs {} of cable, class to the next {}\n", i + 1,
                          Describe({&placement.anchors[i].base, 1}), Metres(result.details.longest_cables[i]),
                          Describe(placement.boundary.sides[i].path.word, names));
    }
    text += fmt::format("  boundary  {} around {}\n", Metres(placement.boundary.length),
                        SquareMetres(placement.boundary.area));
  }
  text +=
      fmt::format("  search    {} evaluations in {} of {} jobs", result.evaluations, result.jobs, search.question.jobs);
  if (!result.history.empty()) {
    const PlaceRecord& last = result.history.back();
    text += fmt::format("; the best came from job {}, evaluation {}", last.job, last.evaluations);
  }
  text += "\n";
  if (result.incomplete > 0) {
    text += fmt::format("  budget    in {} evaluations it ended before all boundaries were found\n", result.incomplete);
  }
  return text + DescribeVerification(answer.verified_curves);
}

}  // namespace

Expected<int> DeliverPlaces(const CommonOptions& options, const Scene& scene, const PlaceSearch& search,
                            std::vector<PlaceJob> jobs) {
  const auto answer = AnswerPlace(search, std::move(jobs), options.verify);
  if (!answer) return tl::unexpected(answer.error());
  const auto draw = [&] { return DrawPlace(scene, search.ground, answer->result); };
  return Deliver(options,
                 {.json = answer->json, .text = ToText(search, *answer), .draw = draw, .status = answer->status});
}

}  // namespace tautline::cli
