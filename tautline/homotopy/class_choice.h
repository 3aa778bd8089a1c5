// The choice of the goal's homotopy class: shortest path first, subject to the tether.
#ifndef TAUTLINE_HOMOTOPY_CLASS_CHOICE_H_
#define TAUTLINE_HOMOTOPY_CLASS_CHOICE_H_

#include <cstdint>
#include <optional>

#include "tautline/homotopy/goal_field.h"
#include "tautline/homotopy/taut_space.h"

namespace tautline {

/// What limits the search.
struct ClassChoiceOptions {
  double max_tether = 0;            ///< Metres, from the walk's start.
  std::int64_t budget = 5'000'000;  ///< Labels after which the search gives up.
  KeepGoing keep_going = {};        ///< Asked now and then; at a no the search throws Stopped.
};

/// What the search found. Without a path and without budget_exceeded, none exists: the search was exhausted.
struct ClassChoice {
  std::optional<Polyline> path;  ///< From the robot to the goal, taut.
  std::int64_t labels = 0;       ///< Labels looked at.
  /// The search gave up: nothing is proved.
  bool budget_exceeded = false;
};

/// The shortest path from the end of `laid` (the cable, walked from the base) to the goal of `field` such that the taut
/// tether at the goal is no longer than max_tether. Requires that the laid cable, pulled taut, fits. Exact. Labels
/// that have merged with their tether number at most the Pareto-optimal (path, tether) pairs per directed edge of the
/// visibility graph; those that have not see the laid cable across open ground, which bounds their number as well.
ClassChoice ChooseClass(const TautSpace& space, const Walk& laid, const GoalDistances& field,
                        const ClassChoiceOptions& options);

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_CLASS_CHOICE_H_
