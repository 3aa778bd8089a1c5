// An independent check of a plan, by other means than those that found it.
#ifndef TAUTLINE_PLANNERS_TETHER_VERIFY_PLAN_H_
#define TAUTLINE_PLANNERS_TETHER_VERIFY_PLAN_H_

#include <string>
#include <vector>

#include "tautline/planners/tether/plan.h"
#include "tautline/planners/tether/tether_planner.h"

namespace tautline {

/// What a check of an answer found.
struct Verification {
  std::vector<std::string> faults;  ///< What is wrong, one sentence each; empty when the plan holds.
  int curves = 0;                   ///< Taut curves that were checked.
  int samples = 0;                  ///< Places along the motion at which the tether was checked.

  /// Whether nothing is wrong.
  bool ok() const { return faults.empty(); }
};

/// How thorough the check is.
struct VerifyOptions {
  int samples = 32;  ///< Evenly spaced along the motion.
};

/// Checks every curve of the result against the boundary rings alone: each lies in the free space, is locally shortest
/// (it bends only at boundary vertices, around the obstacle there), and has the length and the word that it claims, by
/// a count of ray crossings of its own. By uniqueness of the taut curve in a class, matching words then prove that the
/// start is the laid cable pulled taut and that the tether at the goal is the one that the motion leaves behind. Along
/// the motion the tether is proposed by the engine, checked in the same way, and compared with the limit. For an
/// infeasible result it checks the reason: that the goal, the robot or the cable really is on blocked ground, that no
/// component holds both cable and goal, that the laid cable or the shortest tether named is longer than the limit. A
/// socket's stub must lie in the free ground without clearance. O(samples * corners * n) for n boundary vertices, and
/// O(n^2) where a base is said to have no way out of its socket.
Verification VerifyPlan(const TetherPlanner& planner, const Tether& tether, Point goal, const PlanResult& result,
                        const VerifyOptions& options = {});

/// Every fault (CurveFaults) of the laid cable pulled taut, base first, with its stub: it must be of the class of the
/// cable as laid.
std::vector<std::string> LaidCableFaults(const TetherPlanner& planner, const Tether& tether, const LaidCable& laid,
                                         const TautPath& taut);

/// What speaks against the claim that the cable cannot lie as it is said to: kStartBlocked or kLaidCableBlocked.
std::vector<std::string> BlockedFaults(const TetherPlanner& planner, const Tether& tether, PlanObstruction obstruction);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_VERIFY_PLAN_H_
