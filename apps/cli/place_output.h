// The answer of `tautline workspace place` and `tautline workspace merge`.
#ifndef APPS_CLI_PLACE_OUTPUT_H_
#define APPS_CLI_PLACE_OUTPUT_H_

#include <vector>

#include "apps/answers/place_answer.h"
#include "apps/cli/common_options.h"

namespace tautline::cli {

/// Joins the jobs and hands out what they found; the exit status. Errors: as AnswerPlace and Deliver.
[[nodiscard]] Expected<int> DeliverPlaces(const CommonOptions& options, const Scene& scene, const PlaceSearch& search,
                                          std::vector<PlaceJob> jobs);

}  // namespace tautline::cli

#endif  // APPS_CLI_PLACE_OUTPUT_H_
