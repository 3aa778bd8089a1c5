// The question of `workspace place`, answered: what every face of tautline hands out.
#ifndef APPS_ANSWERS_PLACE_ANSWER_H_
#define APPS_ANSWERS_PLACE_ANSWER_H_

#include <string>
#include <vector>

#include "apps/answers/exit_status.h"
#include "apps/answers/place_search.h"
#include "tautline/planners/cable_workspace/place.h"

namespace tautline {

struct PlaceAnswer {
  PlaceResult result;
  Json json = {};  ///< The result as docs/workspace_place.md describes it.
  ExitStatus status = kExitSolved;
  int verified_curves = 0;  ///< How many taut curves were verified.
};

/// A part by its name.
struct NamedPart {
  std::string name;  ///< Of its file.
  std::vector<PlaceJob> jobs;
};

/// The jobs of all parts. Errors: a job stands in two of them; unless `unfinished`, one stands in none.
[[nodiscard]] Expected<std::vector<PlaceJob>> JoinParts(const PlaceSearch& search, std::vector<NamedPart> parts,
                                                        bool unfinished);

/// What finished jobs found together: the same bytes whoever ran them. Errors: as JoinPlaceJobs. Throws
/// std::logic_error where the answer fails verification.
[[nodiscard]] Expected<PlaceAnswer> AnswerPlace(const PlaceSearch& search, std::vector<PlaceJob> jobs, bool verify);

}  // namespace tautline

#endif  // APPS_ANSWERS_PLACE_ANSWER_H_
