// Checks of a reach result by other means than those that made it.
#ifndef TAUTLINE_PLANNERS_TETHER_VERIFY_REACH_H_
#define TAUTLINE_PLANNERS_TETHER_VERIFY_REACH_H_

#include "tautline/planners/tether/reach.h"
#include "tautline/planners/tether/verify_plan.h"

namespace tautline {

/// Checks that rings close and have the areas they claim, that the middles of up to 32 of the arcs are at the end of a
/// shortest tether that is free, taut and as long as the limit, that sheets have the areas of their rings, sum up,
/// and are together no smaller than the region. O(boundary) per arc checked.
Verification VerifyReach(const TetherPlanner& planner, const Tether& tether, const ReachResult& result);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_VERIFY_REACH_H_
