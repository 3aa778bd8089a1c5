#include "apps/pictures/workspace_pictures.h"

#include "tautline/draw/draw_candidates.h"
#include "tautline/draw/draw_move.h"
#include "tautline/draw/draw_tour.h"
#include "tautline/draw/draw_workspace.h"

namespace tautline {
namespace {

const FreeSpace& SpaceOf(const WorkspaceSetup& setup) { return setup.ground.space().free_space(); }

/// Why there is no boundary.
template <class Answer>
std::string DrawFault(const Scene& scene, const Answer& answer) {
  return DrawWorkspace(scene, SpaceOf(answer.setup),
                       {.anchors = answer.setup.anchors, .boundary = answer.boundary, .longest = {}});
}

}  // namespace

std::string DrawAnswer(const Scene& scene, const BoundaryAnswer& answer) {
  const FreeSpace& space = SpaceOf(answer.setup);
  if (answer.outcomes) return DrawFutures(scene, space, *answer.boundary, *answer.futures, *answer.outcomes);
  return DrawWorkspace(scene, space,
                       {.anchors = answer.setup.anchors, .boundary = answer.boundary, .longest = answer.longest});
}

std::string DrawAnswer(const Scene& scene, const BestAnswer& answer) {
  CandidatesPicture picture{.candidates = {},
                            .found = answer.found,
                            .complete = answer.complete,
                            .max_boundary = answer.max_boundary,
                            .explanation = answer.explanation};
  for (const RankedBoundary& ranked : answer.ranked) {
    picture.candidates.push_back({&ranked.boundary, ranked.futures ? &*ranked.futures : nullptr});
  }
  return DrawCandidates(scene, SpaceOf(answer.setup), picture);
}

std::string DrawAnswer(const Scene& scene, const PoseAnswer& answer) {
  if (!answer.pose) return DrawFault(scene, answer);
  return DrawPose(
      scene, SpaceOf(answer.setup),
      {.anchors = answer.setup.anchors, .boundary = answer.boundary, .at = answer.at, .pose = *answer.pose});
}

std::string DrawAnswer(const Scene& scene, const MoveAnswer& answer) {
  if (!answer.move) return DrawFault(scene, answer);
  return DrawMove(scene, SpaceOf(answer.setup),
                  {.anchors = answer.setup.anchors,
                   .boundary = *answer.boundary,
                   .start = answer.from,
                   .goal = answer.to,
                   .options = answer.options,
                   .move = *answer.move});
}

std::string DrawAnswer(const Scene& scene, const TourAnswer& answer) {
  if (!answer.tour) return DrawFault(scene, answer);
  return DrawTour(
      scene, SpaceOf(answer.setup),
      {.anchors = answer.setup.anchors, .boundary = *answer.boundary, .stops = answer.stops, .tour = *answer.tour});
}

}  // namespace tautline
