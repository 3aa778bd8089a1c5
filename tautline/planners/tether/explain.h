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
/// Why the cable cannot lie as it is said to: `at` is where it leaves the free space, or where the robot stands, as
/// FollowLaidCable reports it. Requires a fault of the laid cable.
std::string ExplainLaidCable(const TautSpace& space, PlanObstruction obstruction, Point at);
/// "the goal (1, 2) and the robot are in parts ... that are not connected"; `what` is "the goal", `other` "the robot".
std::string ExplainApart(const std::string& what, Point at, const std::string& other);
/// That the laid cable, pulled taut, needs more than the tether has; lengths in metres.
std::string ExplainLaidTooLong(double taut_length, double limit);
/// By how much the tether of length `limit`, metres, falls short of `shortest`, the class that needs the least.
std::string ExplainTooShort(const TautSpace& space, const TautPath& shortest, double limit);
/// That the laid cable, pulled taut, crosses itself at a place, and why that does not go away.
std::string ExplainMustCross(Point at);
/// That the search stopped after its budget of so many steps.
std::string ExplainBudget(std::int64_t budget);
/// That the caller of a search stopped it.
std::string ExplainStopped();
/// That a point needs a tether of `shortest` metres, more than the `limit` there is.
std::string ExplainOutOfReach(Point at, double shortest, double limit);
/// The tether ends before it is out of its socket.
std::string ExplainShortInSocket(double stub_length, double limit);
/// Not all taut walks were counted, but all up to a length.
std::string ExplainSheetBudget(std::int64_t budget, double counted_to);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_EXPLAIN_H_
