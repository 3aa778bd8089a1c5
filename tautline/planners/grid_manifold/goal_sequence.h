// Goals in order, and second thoughts about the visits before one that fails.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_GOAL_SEQUENCE_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_GOAL_SEQUENCE_H_

#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "tautline/planners/grid_manifold/goal_drive.h"

namespace tautline {

/// Visits goals in order. With lookahead, a goal that cannot be visited changes the visits of the goals before it: by
/// other ways, other vertices and intermediate targets, depth first, until one is found after which it can.
class GoalSequence {
 public:
  /// Refers to its arguments.
  GoalSequence(RobotDriver& driver, const DriveOptions& options, std::span<const Point> goals);

  /// The drive, from a state on. Throws Stopped as Drive.
  DriveResult Run(const DriveState& start);

 private:
  /// A visit that second thoughts have found.
  struct Visit {
    GoalOutcome outcome;
    DriveState after;
  };

  /// How hard is tried.
  struct Stage {
    Untangling untangle;
    bool keeps_out;  ///< Of deadlock areas.
  };

  const FieldOfGoal& FieldOf(std::size_t goal);
  bool Has(Stage stage) const;
  DriveOptions Of(Stage stage, int search_trials) const;
  GoalOutcome VisitNext();
  GoalOutcome Attempt(const DriveOptions& options);
  bool ThinkAgain(const DriveOptions& options, int& trials);
  bool VisitFrom(std::size_t goal, const DriveState& state, TrialBudget& budget);
  void TakeFound(std::size_t first);

  RobotDriver& driver_;
  const DriveOptions& options_;
  std::span<const Point> goals_;
  std::vector<GoalOutcome> outcomes_;  ///< Of the goals that were visited.
  std::deque<DriveState> states_;      ///< Before the last of them and the next one; the last is where the robot is.
  std::deque<FieldOfGoal> fields_;     ///< Of the goals from first_field_ on.
  std::size_t first_field_ = 0;

  // While it thinks again.
  const DriveOptions* again_ = nullptr;
  /// By goal and state (StateKey) before it: the most trials with which it led nowhere.
  std::map<std::pair<std::size_t, std::uint64_t>, std::int64_t> tried_;
  std::vector<Visit> found_;  ///< The last one first.
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_GOAL_SEQUENCE_H_
