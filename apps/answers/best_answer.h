// The question of `workspace best`, answered: what every face of tautline hands out.
#ifndef APPS_ANSWERS_BEST_ANSWER_H_
#define APPS_ANSWERS_BEST_ANSWER_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "apps/answers/exit_status.h"
#include "apps/answers/workspace_setup.h"
#include "tautline/planners/cable_workspace/best.h"
#include "tautline/planners/cable_workspace/futures.h"

namespace tautline {

struct BestQuestion {
  std::optional<double> max_boundary;  ///< Metres; absent: that of the scene.
  std::optional<std::int64_t> count;   ///< Only the so many best.
  std::optional<double> longer_to;     ///< Also count the valid boundaries that are longer, up to this, metres.
  std::int64_t budget = 5'000'000;     ///< See BestOptions.
  bool verify = false;                 ///< Check the answer by independent means.
  Watcher watch = {};                  ///< Told how far the preparation is.
  KeepGoing keep_going = {};           ///< See BestOptions.
};

/// One of the best boundaries.
struct RankedBoundary {
  WorkspaceBoundary boundary;
  std::optional<FutureOutcomes> futures;  ///< Where the scene has futures.
};

struct BestAnswer {
  WorkspaceSetup setup;
  double max_boundary = 0;                  ///< As used, metres.
  std::optional<Futures> futures = {};      ///< Where the scene has futures.
  std::vector<RankedBoundary> ranked = {};  ///< Best first: by area, or by expected area with futures.
  std::size_t found = 0;                    ///< How many there are, listed or not.
  bool complete = false;                    ///< None is missing.
  std::string explanation = {};             ///< Why there is none, or why the list is not complete.
  Json json = {};                           ///< The result as docs/workspace_best.md describes it.
  ExitStatus status = kExitSolved;
  int verified_curves = 0;  ///< How many taut curves were verified.
};

/// The best ways to lay the cables. Errors: as SetUpWorkspace; no limit is given; those of Futures::Prepare. Throws
/// std::logic_error where the answer fails verification.
[[nodiscard]] Expected<BestAnswer> AnswerBest(const Scene& scene, const BestQuestion& question);

}  // namespace tautline

#endif  // APPS_ANSWERS_BEST_ANSWER_H_
