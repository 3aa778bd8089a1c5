// What futures bring, as JSON.
#ifndef APPS_ANSWERS_FUTURES_JSON_H_
#define APPS_ANSWERS_FUTURES_JSON_H_

#include "apps/answers/json_values.h"
#include "tautline/planners/cable_workspace/futures.h"

namespace tautline {

/// `expected_area`, `lost_probability`, and `futures`, one by one: `probability`, `status`, then `area` and, in full,
/// `boundary`, `length`, `words` and `max_cable_lengths`, or `reason` and `explanation`.
Json FuturesJson(const Futures& futures, const FutureOutcomes& outcomes, bool in_full);

}  // namespace tautline

#endif  // APPS_ANSWERS_FUTURES_JSON_H_
