// Why there is no plan, as one sentence with the numbers.
#ifndef TAUTLINE_PLANNERS_TETHER_EXPLAIN_H_
#define TAUTLINE_PLANNERS_TETHER_EXPLAIN_H_

#include <cstdint>
#include <string>

#include "tautline/homotopy/taut_space.h"
#include "tautline/planners/tether/plan.h"

namespace tautline {

/// "the goal (1, 2) lies inside ..."; `what` is "the goal".
std::string ExplainBlocked(const TautSpace& space, const std::string& what, Point at);
std::string ExplainLaidCable(const TautSpace& space, PlanObstruction obstruction, Point at);
std::string ExplainUnreachable(Point goal);
std::string ExplainLaidTooLong(double taut_length, double limit);
std::string ExplainTooShort(const TautSpace& space, const TautPath& shortest, double limit);
std::string ExplainBudget(std::int64_t budget);
std::string ExplainStopped();

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_EXPLAIN_H_
