// One goal of a drive, with one controller.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_GOAL_DRIVE_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_GOAL_DRIVE_H_

#include <functional>
#include <memory>
#include <optional>

#include "tautline/planners/grid_manifold/drive.h"
#include "tautline/planners/grid_manifold/goal_visit.h"
#include "tautline/planners/grid_manifold/untangler.h"

namespace tautline {

/// A goal with its field.
struct FieldOfGoal {
  Point goal;                                  ///< Metres.
  DriveFailure failure = DriveFailure::kNone;  ///< kGoalBlocked or kTetherTooShort: no cable makes it possible.
  std::unique_ptr<ManifoldGoalField> field;    ///< Null where it is blocked.
};

/// Looks a goal up on the manifold. O(vertices).
FieldOfGoal FindFieldOfGoal(const GridManifold& manifold, Point goal);

/// Moves states to a goal and says how. Refers to its arguments.
class GoalDrive {
 public:
  /// Asked about the state after a visit of the extended controller: whether it will do.
  using Accepts = std::function<bool(const DriveState&)>;

  /// Requires a goal without failure.
  GoalDrive(RobotDriver& driver, const DriveOptions& options, const FieldOfGoal& goal, TrialBudget& budget,
            const Accepts& accepts = {});
  GoalDrive(const GoalDrive&) = delete;
  GoalDrive& operator=(const GoalDrive&) = delete;

  /// Drives there. The state is where the robot came to; after a failure of the extended controller as it was.
  GoalOutcome Run(DriveState& state);

 private:
  Accepts Restoring(const Accepts& accepts);
  void Fail(LegEnd end);
  void OpenDeadlocksIfNeeded();
  void OpenDeadlocks();
  void Retract(DriveState& state);
  void Extended(DriveState& state);
  bool CommitCarefully(DriveState& state);
  bool CommitByAnyMethod(const GoalVisit& visit, DriveState& state);
  bool Commit(const GoalVisit& visit, Untangling method, DriveState& state);
  bool Take(UntangleResult found, DriveState& state);

  RobotDriver& driver_;
  const DriveOptions& options_;
  const ManifoldGoalField& field_;
  GoalVisit visit_, safe_visit_;
  GoalOutcome outcome_;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_GOAL_DRIVE_H_
