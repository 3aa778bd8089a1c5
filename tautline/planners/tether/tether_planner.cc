#include "tautline/planners/tether/tether_planner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/homotopy/goal_field.h"
#include "tautline/planners/tether/class_choice.h"
#include "tautline/planners/tether/explain.h"

namespace tautline {
namespace {

Polyline Points(const TautCurve& curve) {
  Polyline points;
  for (const TautPoint& p : curve.points) points.push_back(p.point);
  return points;
}

PlanResult Infeasible(PlanResult result, PlanObstruction obstruction, std::string explanation) {
  result.status = PlanStatus::kInfeasible;
  result.obstruction = obstruction;
  result.explanation = std::move(explanation);
  return result;
}

}  // namespace

Expected<TetherPlanner> TetherPlanner::Prepare(const World& world) {
  auto space = BuildFreeSpace(world);
  if (!space) return tl::unexpected(space.error());
  TetherPlanner planner;
  if (space->clearance > 0) {
    const auto ungrown = BuildFreeSpace(world, {.clearance = 0.0});
    if (!ungrown) return tl::unexpected(ungrown.error());
    planner.ungrown_ = std::make_unique<const FreeMesh>(*ungrown);
  }
  planner.space_ = std::make_unique<const TautSpace>(std::move(*space));
  return planner;
}

tl::expected<LaidCable, LaidCableFault> TetherPlanner::FollowLaidCable(const Tether& tether) const {
  const bool has_cable = tether.laid && tether.laid->size() > 1;
  const Point robot = has_cable ? tether.laid->back() : tether.base;
  const auto socket = FindSocket(*space_, ungrown(), tether.base);
  if (!socket) {
    return tl::unexpected(
        LaidCableFault{has_cable ? PlanObstruction::kLaidCableBlocked : PlanObstruction::kStartBlocked, tether.base});
  }
  LaidCable laid{*socket, Walk(socket->exit), socket->stub_length > 0 && !has_cable};
  if (!has_cable) return laid;
  if (!space_->Locate(robot)) return tl::unexpected(LaidCableFault{PlanObstruction::kStartBlocked, robot});
  std::optional<Walk> walk = laid.walk;
  if (const auto departure = space_->Follow(std::span(*tether.laid).subspan(1), walk)) {
    return tl::unexpected(LaidCableFault{PlanObstruction::kLaidCableBlocked, departure->at});
  }
  laid.walk = *walk;
  return laid;
}

TautPath TetherPlanner::TetherAlong(const Socket& socket, const Walk& walk) const {
  Polyline points = Points(PullTaut(space_->mesh(), walk));
  if (socket.stub_length > 0) points.insert(points.begin(), socket.base);
  return space_->MakePath(std::move(points));
}

/// The motion along a path from where the walk of the laid cable ends, with the tether that it ends with.
Motion TetherPlanner::MotionAlong(const LaidCable& laid, const Polyline& path) const {
  std::optional<Walk> walk = laid.walk;
  const auto departure = space_->Follow(path, walk);
  TAUTLINE_CHECK(!departure);
  Motion motion{space_->MakePath(path), TetherAlong(laid.socket, *walk)};
  if (laid.in_socket) {
    Polyline from_base{laid.socket.base};
    from_base.insert(from_base.end(), path.begin(), path.end());
    motion.path = space_->MakePath(std::move(from_base));
  }
  return motion;
}

ClassList TetherPlanner::TethersTo(const Socket& socket, const Walk& root, Place goal,
                                   const ClassOptions& options) const {
  ClassOptions from_exit = options;
  if (options.max_length) from_exit.max_length = *options.max_length - socket.stub_length;
  ClassList list = FindClassesOnward(*space_, root, goal, from_exit);
  if (socket.stub_length == 0) return list;
  for (TautPath& tether : list.classes) {
    tether.points.insert(tether.points.begin(), socket.base);
    tether = space_->MakePath(std::move(tether.points));
  }
  return list;
}

void TetherPlanner::ListAll(const LaidCable& laid, Place goal, const PlanOptions& options, PlanResult& result) const {
  const ClassList tethers =
      TethersTo(laid.socket, laid.Root(), goal,
                {.max_length = result.limit, .max_count = options.max_all, .budget = options.budget});
  const Polyline cable = Points(PullTaut(space_->mesh(), laid.walk));
  const Polyline back(cable.rbegin(), cable.rend());
  for (const TautPath& tether : tethers.classes) {
    // Back along the cable to the exit of the socket, out along the new tether, and taut.
    std::optional<Walk> walk{Walk(laid.robot())};
    const auto out = std::span(tether.points).subspan(laid.socket.stub_length > 0 ? 1 : 0);
    TAUTLINE_CHECK(!space_->Follow(back, walk) && !space_->Follow(out, walk));
    result.all.push_back(MotionAlong(laid, Points(PullTaut(space_->mesh(), *walk))));
  }
  std::stable_sort(result.all.begin(), result.all.end(),
                   [](const Motion& a, const Motion& b) { return a.path.length < b.path.length; });
  result.all_complete = tethers.complete;
}

/// The best motion, and the shorter one that the tether forbids. Requires that a motion exists.
void TetherPlanner::Choose(const LaidCable& laid, const GoalDistances& field, const PlanOptions& options,
                           PlanResult& result) const {
  const double limit = result.limit * (1 + kTetherTolerance);
  const auto direct = FindShortestOnward(*space_, laid.walk, field);
  TAUTLINE_CHECK(direct);
  Motion shortest = MotionAlong(laid, *direct);
  result.status = PlanStatus::kSolved;
  if (shortest.tether.length <= limit) {
    result.motion = std::move(shortest);
    return;
  }
  result.rejected = std::move(shortest);
  const ClassChoice choice =
      ChooseClass(*space_, laid.walk, field, {.max_tether = limit - laid.socket.stub_length, .budget = options.budget});
  TAUTLINE_CHECK(choice.path || choice.budget_exceeded);
  if (choice.path) {
    result.motion = MotionAlong(laid, *choice.path);
  } else {
    result.status = PlanStatus::kBudgetExceeded;
    result.explanation = ExplainBudget(options.budget);
  }
}

PlanResult TetherPlanner::Plan(const Tether& tether, Point goal, const PlanOptions& options) const {
  PlanResult result;
  result.limit = tether.length;
  const double limit = tether.length * (1 + kTetherTolerance);
  const auto place = space_->Locate(goal);
  if (!place) {
    return Infeasible(std::move(result), PlanObstruction::kGoalBlocked, ExplainBlocked(*space_, "the goal", goal));
  }
  const auto laid = FollowLaidCable(tether);
  if (!laid) {
    return Infeasible(std::move(result), laid.error().obstruction,
                      ExplainLaidCable(*space_, laid.error().obstruction, laid.error().at));
  }
  result.start = laid->in_socket ? space_->MakePath({tether.base}) : TetherAlong(laid->socket, laid->walk);
  if (!space_->mesh().Connected(laid->robot(), *place)) {
    return Infeasible(std::move(result), PlanObstruction::kGoalUnreachable, ExplainUnreachable(goal));
  }
  GoalField own_field(*space_, *place, {laid->walk.at, laid->walk.from});
  const GoalDistances field(own_field);
  // From the base on, since where obstacles touch, a robot and its tether keep to their sector.
  auto nearest = FindShortestOnward(*space_, laid->Root(), field);
  if (!nearest) return Infeasible(std::move(result), PlanObstruction::kGoalUnreachable, ExplainUnreachable(goal));
  if (result.start.length > limit) {
    std::string why = ExplainLaidTooLong(result.start.length, tether.length);
    return Infeasible(std::move(result), PlanObstruction::kLaidCableTooLong, std::move(why));
  }
  if (Length(*nearest) + laid->socket.stub_length > limit) {
    if (laid->socket.stub_length > 0) nearest->insert(nearest->begin(), laid->socket.base);
    result.shortest_tether = space_->MakePath(std::move(*nearest));
    std::string why = ExplainTooShort(*space_, *result.shortest_tether, tether.length);
    return Infeasible(std::move(result), PlanObstruction::kTetherTooShort, std::move(why));
  }
  Choose(*laid, field, options, result);
  if (options.all) ListAll(*laid, *place, options, result);
  return result;
}

}  // namespace tautline
