#include "tautline/planners/grid_manifold/drive.h"

#include <algorithm>
#include <utility>

#include "tautline/planners/grid_manifold/untangle_search.h"

namespace tautline {
namespace {

/// One goal with one controller: moves a state there and says how.
class GoalDrive {
 public:
  GoalDrive(RobotDriver& driver, const DriveOptions& options, Point goal, const ManifoldGoalField& field)
      : driver_(driver),
        options_(options),
        field_(field),
        visit_(driver, goal, field, false),
        safe_visit_(driver, goal, field, options.lookahead) {
    outcome_.goal = goal;
  }

  GoalOutcome Run(DriveState& state) {
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
    return outcome_;
  }

 private:
  void Fail(LegEnd end) {
    if (end == LegEnd::kThere) return;
    outcome_.failure = end == LegEnd::kTimeUp ? DriveFailure::kTimeUp : DriveFailure::kWayNotFound;
  }

  /// Where every way without cable leads into a deadlock area, keeping out of them would be to give up the goal.
  void OpenDeadlocksIfNeeded() {
    driver_.Close(options_.deadlocks);
    outcome_.deadlocks_entered = false;
    if (options_.deadlocks.empty()) return;
    const CableClearance no_cable(driver_.manifold().ground(), 0);
    const OpenGround open(driver_.manifold(), no_cable, options_.deadlocks);
    if (FindWay(open, driver_.manifold().base_vertex(), visit_.destination()).empty()) OpenDeadlocks();
  }

  void OpenDeadlocks() {
    driver_.Close({});
    outcome_.deadlocks_entered = true;
  }

  /// [Igarashi2010, Sec. 4.2] The way is open where a trial succeeds: a taut cable sweeps over the ground, so a way
  /// that is open as the cable lies may not stay so.
  void Retract(DriveState& state) {
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

  static bool TakeVisit(std::optional<DriveState> visited, DriveState& state) {
    if (!visited) return false;
    state = *std::move(visited);
    return true;
  }

  /// As careful as asked for, then less so: a goal counts more than what prevention and lookahead are for.
  void Extended(DriveState& state) {
    if (!options_.deadlocks.empty() && !outcome_.deadlocks_entered) {
      if (CommitByAnyMethod(safe_visit_, state)) return;
      OpenDeadlocks();
    }
    if (CommitByAnyMethod(safe_visit_, state)) return;
    if (options_.lookahead && CommitByAnyMethod(visit_, state)) {
      outcome_.retreat_kept = false;
      return;
    }
    if (state.cable.time_s() >= options_.robot.time_limit_s) {
      outcome_.failure = DriveFailure::kTimeUp;
    } else if (outcome_.failure == DriveFailure::kNone) {
      outcome_.failure = DriveFailure::kWayNotFound;
    }
  }

  bool CommitByAnyMethod(const GoalVisit& visit, DriveState& state) {
    for (const Untangling method : {Untangling::kHeuristic, Untangling::kSearch}) {
      if (options_.untangle != Untangling::kBoth && options_.untangle != method) continue;
      if (Commit(visit, method, state)) return true;
    }
    return false;
  }

  /// Visits the goal, with untangling if it must.
  bool Commit(const GoalVisit& visit, Untangling method, DriveState& state) {
    if (TakeVisit(visit.Try(state), state)) return true;
    if (method == Untangling::kHeuristic) {
      return Take(Untangle(driver_, visit, state, options_.max_targets), state);
    }
    UntangleResult found = SearchUntangling(driver_, visit, state, {.max_trials = options_.search_trials});
    outcome_.failure = found.exhausted ? DriveFailure::kNoWay : DriveFailure::kNone;
    outcome_.searched = found.visited.has_value();
    return Take(std::move(found), state);
  }

  bool Take(UntangleResult found, DriveState& state) {
    outcome_.trials += found.trials;
    if (!found.visited) return false;
    outcome_.targets += found.targets;
    outcome_.failure = DriveFailure::kNone;
    state = *std::move(found.visited);
    return true;
  }

  RobotDriver& driver_;
  const DriveOptions& options_;
  const ManifoldGoalField& field_;
  GoalVisit visit_, safe_visit_;
  GoalOutcome outcome_;
};

GoalOutcome DriveToGoal(RobotDriver& driver, const DriveOptions& options, Point goal, DriveState& state) {
  const GridManifold& manifold = driver.manifold();
  const auto cell = manifold.ground().CellAt(goal);
  if (!cell || !manifold.ground().IsFree(*cell)) return {.goal = goal, .failure = DriveFailure::kGoalBlocked};
  const ManifoldGoalField field(manifold, *cell);
  if (field.goals() == 0) return {.goal = goal, .failure = DriveFailure::kTetherTooShort};
  return GoalDrive(driver, options, goal, field).Run(state);
}

}  // namespace

bool DriveResult::Succeeded() const {
  return std::all_of(goals.begin(), goals.end(),
                     [](const GoalOutcome& goal) { return goal.failure == DriveFailure::kNone; });
}

std::size_t DriveResult::RobotContacts() const {
  const auto contacts = end.cable.contacts();
  return static_cast<std::size_t>(std::count_if(
      contacts.begin(), contacts.end(), [](const Contact& contact) { return contact.kind == ContactKind::kRobot; }));
}

VertexMask ClosedBy(const GridManifold& manifold, const DeadlockAreas& areas) {
  VertexMask closed(manifold.pages(), 0);
  for (std::uint32_t page = 0; page < manifold.pages(); ++page) {
    for (TileMask cells = manifold.vertices(page); cells != 0; cells &= cells - 1) {
      const int cell = __builtin_ctzll(cells);
      if (areas.IsClosed({page, cell})) closed[page] |= TileMask{1} << cell;
    }
  }
  return closed;
}

DriveResult Drive(const GridManifold& manifold, const DriveState& start, std::span<const Point> goals,
                  const DriveOptions& options) {
  DriveResult result{.end = start, .goals = {}};
  RobotDriver driver(manifold, options.robot, options.deadlocks);
  for (const Point goal : goals) {
    if (!result.Succeeded()) {
      result.goals.push_back({.goal = goal, .failure = DriveFailure::kNotTried});
      continue;
    }
    result.goals.push_back(DriveToGoal(driver, options, goal, result.end));
    if (options.on_goal) options.on_goal(result.goals.size());
  }
  return result;
}

DriveState Replay(const GridManifold& manifold, const DriveState& start, std::span<const ManifoldVertex> way,
                  const RobotOptions& options, const RobotDriver::OnTick& on_tick) {
  RobotDriver driver(manifold, options, {});
  DriveState state = start;
  for (const ManifoldVertex v : way) driver.StepTo(v, state, on_tick);
  return state;
}

}  // namespace tautline
