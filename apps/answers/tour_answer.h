// The question of `workspace tour`, answered: what every face of tautline hands out.
#ifndef APPS_ANSWERS_TOUR_ANSWER_H_
#define APPS_ANSWERS_TOUR_ANSWER_H_

#include <cstdint>
#include <optional>
#include <string>

#include "apps/answers/exit_status.h"
#include "apps/answers/workspace_setup.h"
#include "tautline/planners/cable_workspace/tour.h"

namespace tautline {

struct TourQuestion {
  std::optional<Point> from;  ///< Absent: where the cables are laid.
  std::optional<Point> to;    ///< Absent: the goal of the scene, or back to the start where it has none.
  bool round = false;         ///< Back to the start in any case.
  TourOptions options = {};   ///< How hard to search.
  std::uint64_t seed = 1;     ///< Of the search over many tasks.
  bool verify = false;        ///< Check the answer by independent means.
};

struct TourAnswer {
  WorkspaceSetup setup;
  tl::expected<WorkspaceBoundary, BoundaryFault> boundary;
  TourStops stops = {};
  std::optional<tl::expected<Tour, OutsideFault>> tour = {};  ///< Nothing without a boundary.
  std::string explanation = {};                               ///< Why there is none; empty when there is one.
  Json json = {};                                             ///< The result as docs/workspace_tour.md describes it.
  ExitStatus status = kExitSolved;
  int verified_curves = 0;  ///< How many taut curves were verified.
};

/// Plans a tour over the tasks of the scene. Errors: as SetUpWorkspace and LayCables; the start is not known; both `to`
/// and `round`. Throws std::logic_error where the answer fails verification.
[[nodiscard]] Expected<TourAnswer> AnswerTour(const Scene& scene, const TourQuestion& question);

}  // namespace tautline

#endif  // APPS_ANSWERS_TOUR_ANSWER_H_
