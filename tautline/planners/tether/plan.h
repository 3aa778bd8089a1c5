// The shortest motion of one tethered robot that its tether allows.
#ifndef TAUTLINE_PLANNERS_TETHER_PLAN_H_
#define TAUTLINE_PLANNERS_TETHER_PLAN_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tautline/base/error.h"
#include "tautline/base/stop.h"
#include "tautline/homotopy/taut_path.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// How a search ended. kInfeasible is a proof: a finite search was exhausted.
enum class PlanStatus { kSolved, kInfeasible, kBudgetExceeded };

/// Why there is no plan.
enum class PlanObstruction {
  kNone,
  kStartBlocked,      ///< The robot stands inside an obstacle or its clearance.
  kGoalBlocked,       ///< The goal lies inside an obstacle or its clearance.
  kGoalUnreachable,   ///< Goal and robot lie in different components of the free space.
  kLaidCableBlocked,  ///< The cable as laid crosses an obstacle.
  kLaidCableTooLong,  ///< The cable as laid, pulled tight, is longer than the tether.
  kTetherTooShort,    ///< Every class of the goal needs a longer tether.
  kMustCross,         ///< The laid cable, pulled taut, crosses itself, and no crossing was allowed.
};

/// The slug of formats.md: "goal_blocked", ...; "" for kNone.
std::string ToString(PlanObstruction obstruction);

/// A motion and the tether at its end.
struct Motion {
  TautPath path;    ///< The robot's way from start to goal.
  TautPath tether;  ///< The taut tether at the goal, base first.
};

/// What a plan without crossings was found by, and what it costs.
struct CrossingFree {
  std::int64_t classes_examined = 0;  ///< Of the goal.
  /// No crossing-free motion is shorter. False only where the budget ran out.
  bool optimal = false;
  double bound = 0;             ///< No crossing-free motion is shorter than this, metres; the length when `optimal`.
  double retreat_length = 0;    ///< Of the way back along the taut cable and out along the tether at the goal, metres.
  bool around_base = false;     ///< The motion is no shortest path of its class: it bends at the base.
  std::optional<Motion> plain;  ///< The shortest motion that may cross, where it is another one.
};

/// What else is asked, and when the search gives up.
struct PlanOptions {
  /// Also list every class of the goal that the tether allows.
  bool all = false;
  /// At most so many of them, those with the shortest tethers.
  std::int64_t max_all = 100;
  /// The taut tether is never to cross itself, so that the robot never drives across it.
  bool crossing_free = false;
  /// Labels (plan) or classes (`all`) after which the search stops with kBudgetExceeded.
  std::int64_t budget = 5'000'000;
  /// Asked now and then whether to go on: for cancelling, and for time budgets (Until in base/stop.h). At a no the
  /// search stops with kBudgetExceeded.
  KeepGoing keep_going = {};
};

/// The answer: a motion, or why there is none.
struct PlanResult {
  /// How the search ended.
  PlanStatus status = PlanStatus::kInfeasible;
  /// Why there is no motion; kNone unless status is kInfeasible.
  PlanObstruction obstruction = PlanObstruction::kNone;
  std::string explanation;                    ///< One sentence with the numbers when there is no plan.
  double limit = 0;                           ///< The tether's length, metres.
  TautPath start;                             ///< The laid cable pulled tight, base first; empty when it is blocked.
  std::optional<Motion> motion;               ///< The best motion, when solved.
  std::optional<Motion> rejected;             ///< The shortest motion with any tether, where the limit forbids it.
  std::optional<TautPath> shortest_tether;    ///< For kTetherTooShort: the class that needs the least tether.
  std::vector<Motion> all;                    ///< With PlanOptions::all: shortest motion first.
  bool all_complete = false;                  ///< No class within the limit is missing from `all`.
  std::optional<CrossingFree> crossing_free;  ///< With PlanOptions::crossing_free, when solved.
};

/// Plans on the scene's world, tether and goal. The robot and its tether share one free space; the taut tether may be
/// crossed unless PlanOptions::crossing_free. The answer is exact: the shortest motion over all classes whose taut
/// tether is no longer than the limit. Errors: the scene has no tether or no goal, or one that CheckTether or CheckGoal
/// refuses, or the world has no free space. Cost: preparation O(n log n) plus the reduced visibility graph, then a
/// label-setting search over its directed edges. [Igarashi2010 for the question; Yang2022 for the convexity that makes
/// the search one of classes alone]
[[nodiscard]] Expected<PlanResult> Plan(const Scene& scene, const PlanOptions& options = {});

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_PLAN_H_
