#include "tautline/planners/contact_free/select_reference.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/homotopy/class_choice.h"
#include "tautline/homotopy/classes.h"
#include "tautline/homotopy/word_path.h"
#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

/// A robot that touches an obstacle may stand this far inside the ground grown around it, as a share of the growth:
/// rounded corners err outwards by 1 %, and the margin below by 2 %.
constexpr double kTouchingShare = 0.05;

std::string Blocked(const TautSpace& space, const std::string& what, Point at) {
  return what + " " + ToText(at) + " lies " + BlockedText(space.free_space());
}

Polyline Points(const TautCurve& curve) {
  Polyline points;
  for (const TautPoint& p : curve.points) points.push_back(p.point);
  return points;
}

FollowedTether Refuse(ReferenceOutcome outcome, std::string explanation) {
  return {std::nullopt, outcome, std::move(explanation)};
}

/// From exit to exit, along the cable itself or, where that leaves the ground, along the taut curve of its word.
std::optional<Walk> WalkAlong(const TautSpace& space, const Socket& base, const Socket& robot, const Polyline& laid) {
  std::optional<Walk> walk{Walk(base.exit)};
  const Point robot_exit[] = {robot.exit.point};
  if (!space.Follow(std::span(laid).subspan(1), walk) && !space.Follow(robot_exit, walk)) return walk;
  Polyline between{base.exit.point};
  between.insert(between.end(), laid.begin(), laid.end());
  between.push_back(robot.exit.point);
  if (!space.mesh().Connected(base.exit, robot.exit)) return std::nullopt;
  const auto taut = FindWordPath(space, base.exit, robot.exit, space.rays().WordOf(between));
  if (!taut) return std::nullopt;
  walk = Walk(base.exit);
  if (space.Follow(taut->points, walk)) return std::nullopt;
  return walk;
}

/// Chooses among the classes; the parts of the answer are written one by one.
class ReferenceSearch {
 public:
  ReferenceSearch(const TautGround& ground, const ReferenceTask& task, const SelectReferenceOptions& options)
      : space_(ground.space()), task_(task), options_(options), limit_(task.cable_length_m * (1 + kLengthTolerance)) {}

  ReferenceSelection Run(const TautGround& ground) {
    FollowedTether followed = FollowTether(ground, task_.laid);
    if (!followed.laid) {
      End(followed.outcome, std::move(followed.explanation));
      return std::move(result_);
    }
    laid_ = &*followed.laid;
    try {
      Decide();
    } catch (const Stopped&) {
      End(ReferenceOutcome::kBudgetExceeded, "the search was stopped by its caller with the question still open");
    }
    return std::move(result_);
  }

 private:
  void End(ReferenceOutcome outcome, std::string explanation) {
    result_.outcome = outcome;
    result_.explanation = std::move(explanation);
    result_.reference.reset();
  }

  void Decide() {
    const auto goal = space_.Locate(task_.goal);
    if (!goal) return End(ReferenceOutcome::kGoalBlocked, Blocked(space_, "the goal", task_.goal));
    std::optional<Polyline> nearest;
    if (space_.mesh().Connected(laid_->robot.exit, *goal)) {
      field_.emplace(
          space_, *goal,
          GoalFieldOptions{.targets = {laid_->walk.at, laid_->walk.from}, .keep_going = options_.keep_going});
      nearest = FindShortestOnward(space_, laid_->Root(), GoalDistances(*field_));
    }
    if (!nearest) {
      return End(ReferenceOutcome::kGoalUnreachable, "the goal " + ToText(task_.goal) +
                                                         " and the robot are in parts of the free ground that are not "
                                                         "connected; choose another goal");
    }
    if (options_.list > 0) List(*goal);
    TautPath shortest = FromBase(*std::move(nearest));
    if (shortest.length > limit_) {
      End(ReferenceOutcome::kTetherTooShort, ExplainTetherTooShort(space_, shortest, task_.cable_length_m));
      result_.shortest_tether = std::move(shortest);
      return;
    }
    Choose(*goal);
  }

  TautPath FromBase(Polyline from_exit) const {
    if (laid_->base.stub_length > 0) from_exit.insert(from_exit.begin(), laid_->base.base);
    return space_.MakePath(std::move(from_exit));
  }

  /// The class of a path from where the robot comes out.
  ReferenceCandidate CandidateOf(const Polyline& path) const {
    std::optional<Walk> walk = laid_->walk;
    const auto departure = space_.Follow(path, walk);
    TAUTLINE_CHECK(!departure);
    ReferenceCandidate candidate{.path = laid_->PathFromRobot(space_, path),
                                 .tether = laid_->TetherAlong(space_, *walk)};
    candidate.tether_word = candidate.tether->word;
    candidate.fits = candidate.tether->length <= limit_;
    return candidate;
  }

  void List(Place goal) {
    const ClassList list =
        FindClassesOnward(space_, laid_->walk, goal,
                          {.max_count = options_.list, .budget = options_.budget, .keep_going = options_.keep_going});
    for (const TautPath& path : list.classes) result_.candidates.push_back(CandidateOf(path.points));
    result_.all_listed = list.complete;
  }

  /// Requires that some class fits.
  void Choose(Place goal) {
    const auto direct = FindShortestOnward(space_, laid_->walk, GoalDistances(*field_));
    TAUTLINE_CHECK(direct);
    const ReferenceCandidate shortest = CandidateOf(*direct);
    if (shortest.fits) return Take(shortest);
    if (laid_->Pull(space_).length > limit_) return TryTethers(goal);
    const ClassChoice choice = ChooseClass(
        space_, laid_->walk, GoalDistances(*field_),
        {.max_tether = limit_ - laid_->base.stub_length, .budget = options_.budget, .keep_going = options_.keep_going});
    TAUTLINE_CHECK(choice.path || choice.budget_exceeded);
    if (!choice.path) return GiveUp();
    Take(CandidateOf(*choice.path));
  }

  void Take(const ReferenceCandidate& chosen) {
    result_.outcome = ReferenceOutcome::kFound;
    result_.reference = ReferencePath{.path = chosen.path.points,
                                      .length_m = chosen.path.length,
                                      .word = chosen.path.word,
                                      .tether_word = chosen.tether_word,
                                      .tether_length_m = chosen.tether->length};
  }

  /// All tethers that fit, each with the path that leads to it: back along the cable, and taut.
  void TryTethers(Place goal) {
    const ClassList tethers =
        FindClassesOnward(space_, laid_->Root(), goal,
                          {.max_length = task_.cable_length_m - laid_->base.stub_length / (1 + kLengthTolerance),
                           .budget = options_.budget,
                           .keep_going = options_.keep_going});
    const Polyline cable = Points(PullTaut(space_.mesh(), laid_->walk));
    const Polyline back(cable.rbegin(), cable.rend());
    std::optional<ReferenceCandidate> best;
    for (const TautPath& tether : tethers.classes) {
      std::optional<Walk> walk{Walk(Place{laid_->walk.at, laid_->walk.sleeve.back()})};
      TAUTLINE_CHECK(!space_.Follow(back, walk) && !space_.Follow(tether.points, walk));
      ReferenceCandidate candidate = CandidateOf(Points(PullTaut(space_.mesh(), *walk)));
      if (!best || candidate.path.length < best->path.length) best = std::move(candidate);
    }
    if (!tethers.complete) return GiveUp();
    TAUTLINE_CHECK(best);
    Take(*best);
  }

  void GiveUp() {
    End(ReferenceOutcome::kBudgetExceeded, "the search stopped after its budget of " + std::to_string(options_.budget) +
                                               " steps with the question still open");
  }

  const TautSpace& space_;
  const ReferenceTask& task_;
  const SelectReferenceOptions& options_;
  double limit_;
  const LaidTether* laid_ = nullptr;
  std::optional<GoalField> field_;
  ReferenceSelection result_;
};

/// A path must keep a robot's disc away from obstacles by more than rounding, since touching is a contact: this share
/// of its radius.
constexpr double kTouchMargin = 0.02;

}  // namespace

Expected<TautGround> PrepareRobotGround(World world, double robot_radius_m, const Watcher& watch) {
  if (!std::isfinite(robot_radius_m) || robot_radius_m < 0) {
    return InvalidInput("the robot's radius must be 0 or larger and finite", "radius");
  }
  world.clearance = std::max(world.clearance, (1 + kTouchMargin) * robot_radius_m);
  return TautGround::Prepare(world, watch);
}

TautPath LaidTether::TetherAlong(const TautSpace& space, const Walk& from_exit) const {
  Polyline points = Points(PullTaut(space.mesh(), from_exit));
  if (base.stub_length > 0) points.insert(points.begin(), base.base);
  return space.MakePath(std::move(points));
}

TautPath LaidTether::PathFromRobot(const TautSpace& space, Polyline from_exit) const {
  if (robot.stub_length > 0) from_exit.insert(from_exit.begin(), robot.base);
  return space.MakePath(std::move(from_exit));
}

Walk LaidTether::Root() const {
  Walk root(Place{walk.from, walk.sleeve.front()});
  root.rooted = !walk.is_free_to_turn();
  return root;
}

std::string ToString(ReferenceOutcome outcome) {
  switch (outcome) {
    case ReferenceOutcome::kFound:
      return "";
    case ReferenceOutcome::kStartBlocked:
      return "start_blocked";
    case ReferenceOutcome::kLaidCableBlocked:
      return "laid_cable_blocked";
    case ReferenceOutcome::kGoalBlocked:
      return "goal_blocked";
    case ReferenceOutcome::kGoalUnreachable:
      return "goal_unreachable";
    case ReferenceOutcome::kTetherTooShort:
      return "tether_too_short";
    case ReferenceOutcome::kBudgetExceeded:
      return "budget_exceeded";
  }
  return "";
}

FollowedTether FollowTether(const TautGround& ground, const Polyline& laid) {
  TAUTLINE_CHECK(!laid.empty());
  const TautSpace& space = ground.space();
  const auto base = FindSocket(space, ground.ungrown(), laid.front());
  if (!base) return Refuse(ReferenceOutcome::kStartBlocked, Blocked(space, "the base", laid.front()));
  if (laid.size() == 1) return {LaidTether{*base, *base, Walk(base->exit)}, ReferenceOutcome::kFound, ""};
  const auto robot = FindSocket(space, ground.ungrown(), laid.back());
  const double most_inside = kTouchingShare * space.free_space().clearance;
  // A robot that has not left the neighbourhood of its base may be in the same socket.
  const bool near_base = base->stub_length > 0 && Distance(laid.front(), laid.back()) <= base->stub_length;
  if (!robot || (robot->stub_length > most_inside && !near_base)) {
    return Refuse(ReferenceOutcome::kStartBlocked, Blocked(space, "the robot", laid.back()));
  }
  auto walk = WalkAlong(space, *base, *robot, laid);
  if (!walk) {
    return Refuse(ReferenceOutcome::kLaidCableBlocked,
                  "the cable as laid leaves the free ground where the robot could not have drawn it");
  }
  return {LaidTether{*base, *robot, *std::move(walk)}, ReferenceOutcome::kFound, ""};
}

std::string ExplainTetherTooShort(const TautSpace& space, const TautPath& shortest, double cable_length_m) {
  return "the cable of " + Metres(cable_length_m) + " is " + Metres(shortest.length - cable_length_m) +
         " too short: the goal needs at least " + Metres(shortest.length) + ", in the class '" +
         ToString(shortest.word, space.rays().names()) + "'; choose another goal";
}

ReferenceSelection SelectReference(const TautGround& ground, const ReferenceTask& task,
                                   const SelectReferenceOptions& options) {
  return ReferenceSearch(ground, task, options).Run(ground);
}

}  // namespace tautline
