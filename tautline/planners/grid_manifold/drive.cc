#include "tautline/planners/grid_manifold/drive.h"

#include <algorithm>

#include "tautline/planners/grid_manifold/goal_sequence.h"

namespace tautline {

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
  RobotDriver driver(manifold, options.robot, options.deadlocks);
  return GoalSequence(driver, options, goals).Run(start);
}

DriveState Replay(const GridManifold& manifold, const DriveState& start, std::span<const ManifoldVertex> way,
                  const RobotOptions& options, const RobotDriver::OnTick& on_tick) {
  RobotDriver driver(manifold, options, {});
  DriveState state = start;
  for (const ManifoldVertex v : way) driver.StepTo(v, state, on_tick);
  return state;
}

}  // namespace tautline
