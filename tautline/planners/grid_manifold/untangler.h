// Untangling by intermediate targets [Igarashi2010, Sec. 4.3].
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_UNTANGLER_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_UNTANGLER_H_

#include <cstddef>
#include <optional>

#include "tautline/planners/grid_manifold/goal_visit.h"

namespace tautline {

/// A drive to an intermediate target, tried on a copy.
struct TargetTrial {
  DriveState after;                   ///< Where it ended: at the target, where the way opened, or where it was blocked.
  bool touched = false;               ///< It ended because the robot pulled its cable under itself.
  std::optional<DriveState> visited;  ///< Where the way to the goal opened: the state after the visit.
};

/// Drives a copy of `state` to a target until the way to the goal is open and a visit succeeds. The way is looked at
/// each time that the robot has driven as far as it is wide, after each visit that failed twice as far, and at the end.
TargetTrial TryTarget(RobotDriver& driver, const GoalVisit& visit, const DriveState& state, ManifoldVertex target);

/// What untangling came to.
struct UntangleResult {
  std::optional<DriveState> visited;  ///< The state after the visit; nothing where no way was found.
  int targets = 0;                    ///< Intermediate targets on the way.
  int trials = 0;                     ///< Motions that were simulated.
  bool exhausted = false;             ///< There is none, up to the resolution: only a search says so.
};

/// The heuristic: as long as the way is blocked, to the first candidate whose trial opens it, else to the one that
/// leaves the largest accessible region. Candidates that lead to a state where it was before, and those that lose the
/// retreat, are passed over. Gives up without a candidate, or after `max_targets`. Not more than a heuristic.
UntangleResult Untangle(RobotDriver& driver, const GoalVisit& visit, const DriveState& start, int max_targets);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_UNTANGLER_H_
