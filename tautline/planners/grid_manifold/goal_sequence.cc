#include "tautline/planners/grid_manifold/goal_sequence.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "tautline/planners/grid_manifold/state_key.h"

namespace tautline {
namespace {

/// Visits that may change, with the one that failed. Each has a field of the size of the manifold.
constexpr std::size_t kMostChanged = 8;
/// Trials of the search for one visit while visits change: what is easy with another visit before is found sooner.
constexpr int kTrialsWhileChanging = 40;
/// One in so many trials may be used up for keeping out of deadlock areas: they close much that is none.
constexpr int kKeepOutShare = 4;
/// Trials of the first round, and of these and those of later rounds the least that a choice may use up.
constexpr std::int64_t kFirstRound = 250, kLeastShare = 30;
/// One in so many of what is left may be used up by one choice.
constexpr std::int64_t kChoices = 4;

}  // namespace

GoalSequence::GoalSequence(RobotDriver& driver, const DriveOptions& options, std::span<const Point> goals)
    : driver_(driver), options_(options), goals_(goals) {}

const FieldOfGoal& GoalSequence::FieldOf(std::size_t goal) {
  while (first_field_ + fields_.size() <= goal) {
    if (fields_.size() == kMostChanged) {
      fields_.pop_front();
      ++first_field_;
    }
    fields_.push_back(FindFieldOfGoal(driver_.manifold(), goals_[first_field_ + fields_.size()]));
  }
  return fields_[goal - first_field_];
}

DriveResult GoalSequence::Run(const DriveState& start) {
  outcomes_.clear();
  states_.assign(1, start);
  std::optional<GoalOutcome> failure;
  while (!failure && outcomes_.size() < goals_.size()) {
    const GoalOutcome outcome = VisitNext();
    if (outcome.failure != DriveFailure::kNone) failure = outcome;
    if (options_.on_goal) options_.on_goal(outcomes_.size());
  }
  if (failure) outcomes_.push_back(*failure);
  while (outcomes_.size() < goals_.size()) {
    outcomes_.push_back({.goal = goals_[outcomes_.size()], .failure = DriveFailure::kNotTried});
  }
  return {.end = std::move(states_.back()), .goals = std::move(outcomes_)};
}

/// What is easy with other visits before comes before what is hard with those that there are.
GoalOutcome GoalSequence::VisitNext() {
  if (const FieldOfGoal& field = FieldOf(outcomes_.size()); field.failure != DriveFailure::kNone) {
    return {.goal = field.goal, .failure = field.failure, .time_s = states_.back().cable.time_s()};
  }
  if (!options_.lookahead || options_.controller != DriveController::kExtended) return Attempt(options_);
  GoalOutcome outcome;
  int trials = 0;
  for (const Stage stage : {Stage{Untangling::kHeuristic, true},
                            {Untangling::kHeuristic, false},
                            {Untangling::kSearch, true},
                            {Untangling::kSearch, false}}) {
    if (!Has(stage)) continue;
    outcome = Attempt(Of(stage, options_.search_trials));
    if (outcome.failure == DriveFailure::kNone) return outcome;
    trials += outcome.trials;
    outcome.trials = trials;
    if (outcome.failure == DriveFailure::kTimeUp) return outcome;
    if (ThinkAgain(Of(stage, kTrialsWhileChanging), trials)) return outcomes_.back();
    outcome.trials = trials;
  }
  return outcome;
}

/// The search need not keep out where the heuristic did not manage to.
bool GoalSequence::Has(Stage stage) const {
  if (stage.keeps_out && options_.deadlocks.empty()) return false;
  if (options_.untangle == stage.untangle) return true;
  return options_.untangle == Untangling::kBoth && (stage.untangle == Untangling::kHeuristic || !stage.keeps_out);
}

DriveOptions GoalSequence::Of(Stage stage, int search_trials) const {
  DriveOptions options = options_;
  options.untangle = stage.untangle;
  options.search_trials = std::min(options.search_trials, search_trials);
  if (stage.keeps_out) {
    options.lookahead_trials /= kKeepOutShare;
  } else {
    options.deadlocks.clear();
  }
  return options;
}

GoalOutcome GoalSequence::Attempt(const DriveOptions& options) {
  DriveState state = states_.back();
  TrialBudget budget;
  GoalOutcome outcome = GoalDrive(driver_, options, FieldOf(outcomes_.size()), budget).Run(state);
  outcome.deadlocks_entered |= options.deadlocks.empty() && !options_.deadlocks.empty();
  if (outcome.failure != DriveFailure::kNone) {
    states_.back() = std::move(state);
    return outcome;
  }
  outcomes_.push_back(outcome);
  states_.push_back(std::move(state));
  if (states_.size() > kMostChanged) states_.pop_front();
  return outcome;
}

/// By rounds, each with four times the trials of the one before: a share of them is all that one choice may use up, so
/// that the first choices are not made once and for all.
bool GoalSequence::ThinkAgain(const DriveOptions& options, int& trials) {
  again_ = &options;
  tried_.clear();
  found_.clear();
  const std::size_t first = outcomes_.size() + 1 - states_.size();
  std::int64_t left = options.lookahead_trials;
  for (std::int64_t round = kFirstRound; left > 0; round *= kChoices) {
    TrialBudget budget{std::min(left, round)};
    const std::int64_t had = budget.left;
    const bool found = VisitFrom(first, states_.front(), budget);
    trials += static_cast<int>(had - budget.left);
    left -= had;
    if (!found) continue;
    TakeFound(first);
    outcomes_.back().trials = trials;
    return true;
  }
  return false;
}

/// Visits all goals from one on to the one that failed.
bool GoalSequence::VisitFrom(std::size_t goal, const DriveState& state, TrialBudget& budget) {
  if (goal > outcomes_.size()) return true;
  std::int64_t& tried = tried_[{goal, StateKey(state, driver_.coarse_m())}];
  if (budget.left <= tried) return false;
  tried = budget.left;
  const std::int64_t share = std::max(kLeastShare, budget.left / kChoices);
  DriveState after = state;
  const auto go_on = [&](const DriveState& visited) {
    TrialBudget part{std::min(share, budget.left)};
    const std::int64_t had = part.left;
    const bool found = VisitFrom(goal + 1, visited, part);
    budget.left -= had - part.left;
    return found;
  };
  GoalOutcome outcome = GoalDrive(driver_, *again_, FieldOf(goal), budget, go_on).Run(after);
  outcome.deadlocks_entered |= again_->deadlocks.empty() && !options_.deadlocks.empty();
  if (outcome.failure != DriveFailure::kNone) return false;
  found_.push_back({outcome, std::move(after)});
  return true;
}

void GoalSequence::TakeFound(std::size_t first) {
  states_.erase(states_.begin() + 1, states_.end());
  outcomes_.resize(first);
  for (auto visit = found_.rbegin(); visit != found_.rend(); ++visit) {
    visit->outcome.thought_again = true;
    outcomes_.push_back(visit->outcome);
    states_.push_back(std::move(visit->after));
  }
  if (states_.size() > kMostChanged) states_.pop_front();
}

}  // namespace tautline
