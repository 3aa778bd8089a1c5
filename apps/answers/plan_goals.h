// One tether as it lies, many goals: what `plan --goals` answers.
#ifndef APPS_ANSWERS_PLAN_GOALS_H_
#define APPS_ANSWERS_PLAN_GOALS_H_

#include <memory>

#include "apps/answers/plan_answer.h"

namespace tautline {

/// The answer to one goal.
struct GoalAnswer {  // NOLINT(bugprone-exception-escape): the JSON library moves its values without noexcept.
  Json json;         ///< The document of `plan` with the goal.
  ExitStatus status = kExitSolved;
};

/// A scene's world and tether, prepared once for all goals. Immutable; goals may be asked for in several threads.
class PlanGoals {
 public:
  /// Prepares. Errors: the scene has no tether, and those of PreparePlanner. Cost: as TetherPlanner::Prepare and
  /// PrepareStart.
  [[nodiscard]] static Expected<PlanGoals> Prepare(const Scene& scene, const PlanQuestion& question);

  /// Plans to one goal. Throws std::logic_error where the answer fails verification. Cost: see TetherPlanner::Plan.
  GoalAnswer Answer(Point goal) const;

  /// The planner of all goals.
  const TetherPlanner& planner() const { return *planner_; }

 private:
  PlanGoals(TetherPlanner planner, const Tether& tether, const PlanQuestion& question);

  std::unique_ptr<const TetherPlanner> planner_;  ///< Where `start_` finds it, also after a move.
  PreparedStart start_;
  JsonValues values_;
  PlanOptions options_;
  bool verify_ = false;
};

}  // namespace tautline

#endif  // APPS_ANSWERS_PLAN_GOALS_H_
