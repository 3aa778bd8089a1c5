#include "tautline/planners/grid_manifold/robot_driver.h"

#include <algorithm>
#include <span>
#include <utility>

#include "tautline/base/check.h"

namespace tautline {
namespace {

constexpr int kStepsPerQuestion = 20;
/// A leg that has become so many times as long as its first way goes to and fro before a cable that goes with it.
constexpr std::size_t kMostDetour = 4;

/// Whether the way from one of its vertices on is open as the cable lies now.
bool IsOpen(const OpenGround& open, const std::vector<ManifoldVertex>& way, std::size_t from) {
  for (std::size_t i = from; i + 1 < way.size(); ++i) {
    if (!open.Allows(way[i], way[i + 1])) return false;
  }
  return true;
}

bool TouchesRobot(std::span<const Contact> contacts) {
  return std::any_of(contacts.begin(), contacts.end(),
                     [](const Contact& contact) { return contact.kind == ContactKind::kRobot; });
}

}  // namespace

RobotDriver::RobotDriver(const GridManifold& manifold, const RobotOptions& options, VertexMask closed)
    : manifold_(manifold),
      options_(options),
      closed_(std::move(closed)),
      clearance_(manifold.ground(), SteppingRadius(options.radius_m, manifold.ground().cell_m())),
      stop_(options.keep_going, kStepsPerQuestion) {
  TAUTLINE_CHECK(options.speed_mps > 0 && options.dt_s > 0);
}

void RobotDriver::Close(VertexMask closed) {
  closed_ = std::move(closed);
  if (closed_.empty()) closed_.resize(held_.size(), 0);
  for (std::size_t page = 0; page < held_.size(); ++page) closed_[page] |= held_[page];
}

bool RobotDriver::IsTimeUp(const DriveState& state) {
  if (state.cable.time_s() < options_.time_limit_s) return false;
  ++time_ups_;
  return true;
}

OpenGround RobotDriver::Look(const DriveState& state) {
  clearance_.Measure(state.cable);
  return {manifold_, clearance_, closed_};
}

/// Straight to a point at the robot's speed; false where the cable or the ground refuses.
bool RobotDriver::Advance(Point to, Cable& cable, const OnTick& on_tick) {
  const double stride = options_.speed_mps * options_.dt_s;
  while (cable.robot() != to) {
    stop_.Step();
    const double rest = Distance(cable.robot(), to);
    // A rest of a thousandth of a stride is rounding, not a step of its own.
    const bool last = rest <= 1.001 * stride;
    const Point next = last ? to : Lerp(cable.robot(), to, stride / rest);
    if (cable.Step(next, last ? rest / options_.speed_mps : options_.dt_s).outcome != StepOutcome::kMoved) return false;
    if (on_tick) on_tick(cable);
    // The engine may move a point by its last bits onto the ground.
    if (last) break;
  }
  return true;
}

void RobotDriver::StepTo(ManifoldVertex to, DriveState& state, const OnTick& on_tick) {
  state.way.push_back(to);
  if (Advance(manifold_.ground().CentreOf(manifold_.CellOf(to)), state.cable, on_tick)) {
    state.at = to;
    return;
  }
  Insert(manifold_, to, held_);
  Insert(manifold_, to, closed_);
  Advance(manifold_.ground().CentreOf(manifold_.CellOf(state.at)), state.cable, on_tick);
}

LegEnd RobotDriver::Drive(const Destination& destination, DriveState& state, const ArrivalCheck& check) {
  std::size_t driven = 0, first_way = 0;
  while (!destination.holds(state.at)) {
    const std::vector<ManifoldVertex> way = FindWay(Look(state), state.at, destination);
    if (first_way == 0) first_way = way.size();
    if (way.empty() || driven > kMostDetour * first_way) return LegEnd::kBlocked;
    for (std::size_t i = 1; i < way.size(); ++i) {
      if (IsTimeUp(state)) return LegEnd::kTimeUp;
      const std::size_t contacts = state.cable.contacts().size();
      StepTo(way[i], state);
      ++driven;
      if (TouchesRobot(state.cable.contacts().subspan(contacts))) return LegEnd::kTouched;
      if (check && check(state)) return LegEnd::kStopped;
      if (state.at != way[i] || !IsOpen(Look(state), way, i)) break;
    }
  }
  return LegEnd::kThere;
}

LegEnd RobotDriver::Follow(const ManifoldGoalField& field, const Destination& destination, DriveState& state) {
  while (!destination.holds(state.at)) {
    if (IsTimeUp(state)) return LegEnd::kTimeUp;
    const auto direction = field.Direction(state.at);
    if (!direction) return LegEnd::kBlocked;
    const ManifoldVertex to = *manifold_.Step(state.at, *direction);
    StepTo(to, state);
    if (state.at != to) return LegEnd::kBlocked;
  }
  return LegEnd::kThere;
}

LegEnd RobotDriver::DriveBack(DriveState& state, const ArrivalCheck& check) {
  const int step = manifold_.atlas().connectivity() == Connectivity::kEight ? 1 : 2;
  while (manifold_.distance(state.at) > 0) {
    if (IsTimeUp(state)) return LegEnd::kTimeUp;
    int d = 0;
    for (;; d += step) {
      TAUTLINE_CHECK(d < kDirections);
      const auto to = manifold_.Step(state.at, d);
      if (to && manifold_.distance(*to) == manifold_.distance(state.at) - StepLength(d)) break;
    }
    const ManifoldVertex from = state.at;
    StepTo(*manifold_.Step(from, d), state);
    if (check(state)) return LegEnd::kStopped;
    if (state.at == from) return LegEnd::kBlocked;
  }
  return LegEnd::kBlocked;
}

}  // namespace tautline
