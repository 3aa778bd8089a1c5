#include "tautline/planners/tether/tether_planner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/homotopy/class_choice.h"
#include "tautline/homotopy/goal_field.h"
#include "tautline/planners/tether/crossing_free.h"
#include "tautline/planners/tether/explain.h"
#include "tautline/scene/check_tether.h"

namespace tautline {
namespace {

Polyline Points(const TautCurve& curve) {
  Polyline points;
  for (const TautPoint& p : curve.points) points.push_back(p.point);
  return points;
}

void SetInfeasible(PlanObstruction obstruction, std::string explanation, PlanResult& result) {
  result.status = PlanStatus::kInfeasible;
  result.obstruction = obstruction;
  result.explanation = std::move(explanation);
}

/// The shortest path from a walk to the goal of a field that was found backwards: from the goal to where the walk is.
std::optional<Polyline> ShortestInto(const TautSpace& space, Place goal, const GoalField& from_walk) {
  auto path = FindShortestOnward(space, Walk(goal), GoalDistances(from_walk));
  if (path) std::reverse(path->begin(), path->end());
  return path;
}

}  // namespace

/// The shortest paths to a goal from the base and from the robot; nothing where there is none.
class ShortestWays {
 public:
  ShortestWays(const TautSpace& space, const PreparedStart& start, Place goal, const GoalDistances& to_goal)
      : space_(space), start_(start), goal_(goal), to_goal_(to_goal) {}

  /// From the base on, since where obstacles touch, a robot and its tether keep to their sector.
  std::optional<Polyline> FromBase() const {
    if (start_.from_base_) return ShortestInto(space_, goal_, *start_.from_base_);
    return FindShortestOnward(space_, start_.laid_->Root(), to_goal_);
  }

  std::optional<Polyline> FromRobot() const {
    if (start_.from_robot_) return ShortestInto(space_, goal_, *start_.from_robot_);
    return FindShortestOnward(space_, start_.laid_->walk, to_goal_);
  }

 private:
  const TautSpace& space_;
  const PreparedStart& start_;
  Place goal_;
  const GoalDistances& to_goal_;
};

Expected<TetherPlanner> TetherPlanner::Prepare(const World& world, const PrepareOptions& options) {
  auto ground = TautGround::Prepare(world, options.watch);
  if (!ground) return tl::unexpected(ground.error());
  return TetherPlanner(*std::move(ground));
}

tl::expected<LaidCable, LaidCableFault> TetherPlanner::FollowLaidCable(const Tether& tether) const {
  TAUTLINE_CHECK(CheckTether(tether, space().free_space().box));
  const bool has_cable = tether.laid && tether.laid->size() > 1;
  const Point robot = has_cable ? tether.laid->back() : tether.base;
  const auto socket = FindSocket(space(), ungrown(), tether.base);
  if (!socket) {
    return tl::unexpected(
        LaidCableFault{has_cable ? PlanObstruction::kLaidCableBlocked : PlanObstruction::kStartBlocked, tether.base});
  }
  LaidCable laid{*socket, Walk(socket->exit), socket->stub_length > 0 && !has_cable};
  if (!has_cable) return laid;
  if (!space().Locate(robot)) return tl::unexpected(LaidCableFault{PlanObstruction::kStartBlocked, robot});
  std::optional<Walk> walk = laid.walk;
  if (const auto departure = space().Follow(std::span(*tether.laid).subspan(1), walk)) {
    return tl::unexpected(LaidCableFault{PlanObstruction::kLaidCableBlocked, departure->at});
  }
  laid.walk = *walk;
  return laid;
}

TautPath TetherPlanner::TetherAlong(const Socket& socket, const Walk& walk) const {
  Polyline points = Points(PullTaut(space().mesh(), walk));
  if (socket.stub_length > 0) points.insert(points.begin(), socket.base);
  return space().MakePath(std::move(points));
}

/// The motion along a path from where the walk of the laid cable ends, with the tether that it ends with.
Motion TetherPlanner::MotionAlong(const LaidCable& laid, const Polyline& path) const {
  std::optional<Walk> walk = laid.walk;
  const auto departure = space().Follow(path, walk);
  TAUTLINE_CHECK(!departure);
  Motion motion{space().MakePath(path), TetherAlong(laid.socket, *walk)};
  if (laid.in_socket) {
    Polyline from_base{laid.socket.base};
    from_base.insert(from_base.end(), path.begin(), path.end());
    motion.path = space().MakePath(std::move(from_base));
  }
  return motion;
}

ClassList TetherPlanner::TethersTo(const Socket& socket, const Walk& root, Place goal,
                                   const ClassOptions& options) const {
  ClassOptions from_exit = options;
  // The tolerance is a share of the whole tether, also where FindClasses sees only a part of it.
  if (options.max_length) {
    from_exit.max_length = *options.max_length - socket.stub_length / (1 + kLengthTolerance);
  }
  ClassList list = FindClassesOnward(space(), root, goal, from_exit);
  if (socket.stub_length == 0) return list;
  for (TautPath& tether : list.classes) {
    tether.points.insert(tether.points.begin(), socket.base);
    tether = space().MakePath(std::move(tether.points));
  }
  return list;
}

void TetherPlanner::ListAll(const LaidCable& laid, Place goal, const PlanOptions& options, PlanResult& result) const {
  const ClassList tethers = TethersTo(laid.socket, laid.Root(), goal,
                                      {.max_length = result.limit,
                                       .max_count = options.max_all,
                                       .budget = options.budget,
                                       .keep_going = options.keep_going});
  const Polyline cable = Points(PullTaut(space().mesh(), laid.walk));
  const Polyline back(cable.rbegin(), cable.rend());
  for (const TautPath& tether : tethers.classes) {
    // Back along the cable to the exit of the socket, out along the new tether, and taut.
    std::optional<Walk> walk{Walk(laid.robot())};
    const auto out = std::span(tether.points).subspan(laid.socket.stub_length > 0 ? 1 : 0);
    TAUTLINE_CHECK(!space().Follow(back, walk) && !space().Follow(out, walk));
    result.all.push_back(MotionAlong(laid, Points(PullTaut(space().mesh(), *walk))));
  }
  std::stable_sort(result.all.begin(), result.all.end(),
                   [](const Motion& a, const Motion& b) { return a.path.length < b.path.length; });
  result.all_complete = tethers.complete;
}

/// The best motion, and the shorter one that the tether forbids. Requires that a motion exists.
void TetherPlanner::Choose(const LaidCable& laid, const Polyline& direct, const GoalDistances& field,
                           const PlanOptions& options, PlanResult& result) const {
  const double limit = result.limit * (1 + kLengthTolerance);
  Motion shortest = MotionAlong(laid, direct);
  if (shortest.tether.length <= limit) {
    result.motion = std::move(shortest);
    result.status = PlanStatus::kSolved;
    return;
  }
  result.rejected = std::move(shortest);
  const ClassChoice choice = ChooseClass(
      space(), laid.walk, field,
      {.max_tether = limit - laid.socket.stub_length, .budget = options.budget, .keep_going = options.keep_going});
  TAUTLINE_CHECK(choice.path || choice.budget_exceeded);
  if (choice.path) {
    result.motion = MotionAlong(laid, *choice.path);
    result.status = PlanStatus::kSolved;
  } else {
    result.status = PlanStatus::kBudgetExceeded;
    result.explanation = ExplainBudget(options.budget);
  }
}

PreparedStart TetherPlanner::StartOf(const Tether& tether) const {
  PreparedStart start(tether, FollowLaidCable(tether));
  if (!start.laid_) return start;
  start.taut_ =
      start.laid_->in_socket ? space().MakePath({tether.base}) : TetherAlong(start.laid_->socket, start.laid_->walk);
  return start;
}

PreparedStart TetherPlanner::PrepareStart(const Tether& tether) const {
  PreparedStart start = StartOf(tether);
  if (!start.laid_) return start;
  const Walk root = start.laid_->Root();
  const Place base{root.at, root.sleeve.back()}, robot = start.laid_->robot();
  if (space().mesh().Sectors(base).size() > 1 || space().mesh().Sectors(robot).size() > 1) return start;
  start.from_base_.emplace(space(), base).GrowTo(std::numeric_limits<double>::infinity());
  start.from_robot_.emplace(space(), robot).GrowTo(std::numeric_limits<double>::infinity());
  return start;
}

PreparedGoal TetherPlanner::GoalAt(Point goal) const {
  TAUTLINE_CHECK(CheckGoal(goal));
  return PreparedGoal(goal, space().Locate(goal));
}

PreparedGoal TetherPlanner::PrepareGoal(Point goal) const {
  PreparedGoal prepared = GoalAt(goal);
  if (!prepared.place_) return prepared;
  prepared.field_.emplace(space(), *prepared.place_).GrowTo(std::numeric_limits<double>::infinity());
  return prepared;
}

PlanResult TetherPlanner::Plan(const Tether& tether, Point goal, const PlanOptions& options) const {
  return Decide(StartOf(tether), GoalAt(goal), options);
}

PlanResult TetherPlanner::Plan(const PreparedStart& start, Point goal, const PlanOptions& options) const {
  return Decide(start, GoalAt(goal), options);
}

PlanResult TetherPlanner::Plan(const Tether& tether, const PreparedGoal& goal, const PlanOptions& options) const {
  return Decide(StartOf(tether), goal, options);
}

PlanResult TetherPlanner::Decide(const PreparedStart& start, const PreparedGoal& goal,
                                 const PlanOptions& options) const {
  PlanResult result;
  result.limit = start.tether_.length;
  try {
    Decide(start, goal, options, result);
  } catch (const Stopped&) {
    result.status = PlanStatus::kBudgetExceeded;
    result.explanation = ExplainStopped();
  }
  return result;
}

void TetherPlanner::Decide(const PreparedStart& start, const PreparedGoal& goal, const PlanOptions& options,
                           PlanResult& result) const {
  const double limit = result.limit * (1 + kLengthTolerance);
  if (!goal.place_) {
    return SetInfeasible(PlanObstruction::kGoalBlocked, ExplainBlocked(space(), "the goal", goal.point_), result);
  }
  if (!start.laid_) {
    const LaidCableFault& fault = start.laid_.error();
    return SetInfeasible(fault.obstruction, ExplainLaidCable(space(), fault.obstruction, fault.at), result);
  }
  const LaidCable& laid = *start.laid_;
  result.start = start.taut_;
  const auto unreachable = [&] {
    SetInfeasible(PlanObstruction::kGoalUnreachable, ExplainApart("the goal", goal.point_, "the robot"), result);
  };
  if (!space().mesh().Connected(laid.robot(), *goal.place_)) return unreachable();

  std::optional<GoalField> own_field;
  if (!goal.field_) {
    own_field.emplace(space(), *goal.place_,
                      GoalFieldOptions{.targets = {laid.walk.at, laid.walk.from}, .keep_going = options.keep_going});
  }
  const GoalDistances field = goal.field_ ? GoalDistances(*goal.field_) : GoalDistances(*own_field);
  const ShortestWays shortest(space(), start, *goal.place_, field);
  std::optional<Polyline> nearest = shortest.FromBase();
  if (!nearest) return unreachable();
  if (result.start.length > limit) {
    return SetInfeasible(PlanObstruction::kLaidCableTooLong, ExplainLaidTooLong(result.start.length, result.limit),
                         result);
  }
  if (Length(*nearest) + laid.socket.stub_length > limit) {
    if (laid.socket.stub_length > 0) nearest->insert(nearest->begin(), laid.socket.base);
    result.shortest_tether = space().MakePath(std::move(*nearest));
    return SetInfeasible(PlanObstruction::kTetherTooShort,
                         ExplainTooShort(space(), *result.shortest_tether, result.limit), result);
  }
  const std::optional<Polyline> direct = laid.at_root() ? nearest : shortest.FromRobot();
  TAUTLINE_CHECK(direct);
  Choose(laid, *direct, field, options, result);
  if (options.crossing_free) CrossingFreeSearch(*this, laid, *goal.place_, options, result).Run(*nearest);
  if (options.all) ListAll(laid, *goal.place_, options, result);
}

}  // namespace tautline
