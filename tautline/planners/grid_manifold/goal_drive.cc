#include "tautline/planners/grid_manifold/goal_drive.h"

#include <utility>

#include "tautline/planners/grid_manifold/untangle_search.h"

namespace tautline {
namespace {

bool TakeVisit(std::optional<DriveState> visited, DriveState& state) {
  if (!visited) return false;
  state = *std::move(visited);
  return true;
}

}  // namespace

FieldOfGoal FindFieldOfGoal(const GridManifold& manifold, Point goal) {
  const auto cell = manifold.ground().CellAt(goal);
  if (!cell || !manifold.ground().IsFree(*cell)) {
    return {.goal = goal, .failure = DriveFailure::kGoalBlocked, .field = nullptr};
  }
  auto field = std::make_unique<ManifoldGoalField>(manifold, *cell);
  const bool too_far = field->goals() == 0;
  return {.goal = goal,
          .failure = too_far ? DriveFailure::kTetherTooShort : DriveFailure::kNone,
          .field = std::move(field)};
}

GoalDrive::GoalDrive(RobotDriver& driver, const DriveOptions& options, const FieldOfGoal& goal, TrialBudget& budget,
                     const Accepts& accepts)
    : driver_(driver),
      options_(options),
      field_(*goal.field),
      visit_(driver, goal.goal, field_, budget, {false, Restoring(accepts)}),
      safe_visit_(driver, goal.goal, field_, budget, {options.keep_retreat, visit_.accepts()}) {
  outcome_.goal = goal.goal;
}

GoalOutcome GoalDrive::Run(DriveState& state) {
  OpenDeadlocksIfNeeded();
  switch (options_.controller) {
    case DriveController::kBasic:
      Fail(driver_.Follow(field_, visit_.destination(), state));
      break;
    case DriveController::kRetract:
      Retract(state);
      break;
    case DriveController::kExtended:
      Extended(state);
      break;
  }
  outcome_.time_s = state.cable.time_s();
  outcome_.steps = state.way.size();
  return outcome_;
}

/// What is asked may drive to other goals, and change what is closed.
GoalDrive::Accepts GoalDrive::Restoring(const Accepts& accepts) {
  if (!accepts) return {};
  return [this, accepts](const DriveState& after) {
    const bool accepted = accepts(after);
    driver_.Close(outcome_.deadlocks_entered ? VertexMask{} : options_.deadlocks);
    return accepted;
  };
}

void GoalDrive::Fail(LegEnd end) {
  if (end == LegEnd::kThere) return;
  outcome_.failure = end == LegEnd::kTimeUp ? DriveFailure::kTimeUp : DriveFailure::kWayNotFound;
}

/// Where every way without cable leads into a deadlock area, keeping out of them would be to give up the goal.
void GoalDrive::OpenDeadlocksIfNeeded() {
  driver_.Close(options_.deadlocks);
  outcome_.deadlocks_entered = false;
  if (options_.deadlocks.empty()) return;
  const CableClearance no_cable(driver_.manifold().ground(), 0);
  const OpenGround open(driver_.manifold(), no_cable, options_.deadlocks);
  if (FindWay(open, driver_.manifold().base_vertex(), visit_.destination()).empty()) OpenDeadlocks();
}

void GoalDrive::OpenDeadlocks() {
  driver_.Close({});
  outcome_.deadlocks_entered = true;
}

/// [Igarashi2010, Sec. 4.2] The way is open where a trial succeeds: a taut cable sweeps over the ground, so a way that
/// is open as the cable lies may not stay so.
void GoalDrive::Retract(DriveState& state) {
  if (TakeVisit(visit_.Try(state), state)) return;
  ++outcome_.targets;
  std::optional<DriveState> visited;
  double looked_s = state.cable.time_s();
  const LegEnd end = driver_.DriveBack(state, [&](const DriveState& now) {
    const bool at_base = now.at == driver_.manifold().base_vertex();
    if (!at_base && now.cable.time_s() < looked_s + driver_.LookAfter()) return false;
    looked_s = now.cable.time_s();
    if (!visit_.IsWayOpen(now)) return false;
    ++outcome_.trials;
    visited = visit_.Try(now);
    return visited.has_value();
  });
  if (!TakeVisit(std::move(visited), state)) Fail(end);
}

void GoalDrive::Extended(DriveState& state) {
  const std::int64_t time_ups = driver_.time_ups();
  if (CommitCarefully(state)) return;
  if (driver_.time_ups() > time_ups) {
    outcome_.failure = DriveFailure::kTimeUp;
  } else if (outcome_.failure == DriveFailure::kNone) {
    outcome_.failure = DriveFailure::kWayNotFound;
  }
}

/// As careful as asked for, then less so: a goal counts more than what prevention and retreats are for.
bool GoalDrive::CommitCarefully(DriveState& state) {
  if (CommitByAnyMethod(safe_visit_, state)) return true;
  // With lookahead, other visits before this one are tried first.
  const bool keeps_out = !options_.deadlocks.empty() && !outcome_.deadlocks_entered;
  if (keeps_out && !options_.lookahead) {
    OpenDeadlocks();
    if (CommitByAnyMethod(safe_visit_, state)) return true;
  }
  if (!options_.keep_retreat || !CommitByAnyMethod(visit_, state)) return false;
  outcome_.retreat_kept = false;
  return true;
}

bool GoalDrive::CommitByAnyMethod(const GoalVisit& visit, DriveState& state) {
  for (const Untangling method : {Untangling::kHeuristic, Untangling::kSearch}) {
    if (options_.untangle != Untangling::kBoth && options_.untangle != method) continue;
    if (Commit(visit, method, state)) return true;
  }
  return false;
}

/// Visits the goal, with untangling if it must.
bool GoalDrive::Commit(const GoalVisit& visit, Untangling method, DriveState& state) {
  if (TakeVisit(visit.Try(state), state)) return true;
  if (method == Untangling::kHeuristic) return Take(Untangle(driver_, visit, state, options_.max_targets), state);
  UntangleResult found = SearchUntangling(driver_, visit, state, {.max_trials = options_.search_trials});
  outcome_.failure = found.exhausted ? DriveFailure::kNoWay : DriveFailure::kNone;
  outcome_.searched = found.visited.has_value();
  return Take(std::move(found), state);
}

bool GoalDrive::Take(UntangleResult found, DriveState& state) {
  outcome_.trials += found.trials;
  if (!found.visited) return false;
  outcome_.targets += found.targets;
  outcome_.failure = DriveFailure::kNone;
  state = *std::move(found.visited);
  return true;
}

}  // namespace tautline
