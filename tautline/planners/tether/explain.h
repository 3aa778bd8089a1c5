// Why there is no plan, or no reaching a point, as one sentence with the numbers.
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

/// Why the robot cannot go to a point that somebody asked about.
std::string ExplainApart(Point at);
std::string ExplainOutOfReach(Point at, double shortest, double limit);
/// The tether ends before it is out of its socket.
std::string ExplainShortInSocket(double stub_length, double limit);
/// Not all taut walks were counted, but all up to a length.
std::string ExplainSheetBudget(std::int64_t budget, double counted_to);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_EXPLAIN_H_
