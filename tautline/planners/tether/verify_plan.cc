#include "tautline/planners/tether/verify_plan.h"

#include <algorithm>
#include <cmath>

#include "tautline/geometry/curve_crossing.h"
#include "tautline/geometry/polygon.h"
#include "tautline/homotopy/curve_faults.h"
#include "tautline/homotopy/ring_ground.h"

namespace tautline {
namespace {

/// Runs the checks and collects what they find.
class Verifier {
 public:
  Verifier(const TetherPlanner& planner, const Tether& tether, Point goal, const PlanResult& result)
      : planner_(planner),
        space_(planner.space().free_space()),
        ground_(space_),
        tether_(tether),
        goal_(goal),
        result_(result) {}

  Verification Run(const VerifyOptions& options) {
    const auto laid = planner_.FollowLaidCable(tether_);
    if (result_.shortest_tether) CheckShortestTether(laid && laid->socket.stub_length > 0);
    if (result_.status == PlanStatus::kInfeasible) CheckObstruction(laid);
    if (!laid) {
      if (result_.motion) Fault("there is a motion although the cable cannot lie as it is said to");
      return std::move(verification_);
    }
    stub_ = laid->socket.stub_length > 0;
    in_socket_ = laid->in_socket;
    if (!result_.start.points.empty()) CheckStart(*laid);
    if (result_.start.points.empty() && result_.obstruction != PlanObstruction::kGoalBlocked) {
      Fault("the tether at the start is missing");
    }
    if (result_.status == PlanStatus::kSolved && !result_.motion) Fault("solved, but there is no motion");
    if (result_.motion) {
      CheckMotion(*result_.motion, "the motion", true);
      CheckAlong(*laid, result_.motion->path, options.samples);
    }
    if (result_.rejected) {
      CheckMotion(*result_.rejected, "the rejected motion", false);
      if (result_.rejected->tether.length <= result_.limit) Fault("the rejected motion was allowed");
      if (result_.motion && result_.rejected->path.length > result_.motion->path.length * (1 + kLengthTolerance)) {
        Fault("the rejected motion is not shorter");
      }
    }
    for (const Motion& motion : result_.all) CheckMotion(motion, "a listed motion", true);
    return std::move(verification_);
  }

 private:
  void Fault(std::string what) { verification_.faults.push_back(std::move(what)); }

  void CheckCurve(const TautPath& path, const std::string& name, bool has_stub) {
    ++verification_.curves;
    for (const std::string& fault : CurveFaults(space_, path, has_stub ? &planner_.ungrown_space() : nullptr)) {
      Fault(std::string(name).append(" ").append(fault));
    }
  }

  bool Near(Point a, Point b) const { return Distance(a, b) <= 2 * planner_.space().tolerance(); }

  void CheckStart(const LaidCable& laid) {
    ++verification_.curves;
    for (const std::string& fault : LaidCableFaults(planner_, tether_, laid, result_.start)) {
      Fault("the tether at the start " + fault);
    }
  }

  /// That the reason for which there is no motion holds.
  void CheckObstruction(const tl::expected<LaidCable, LaidCableFault>& laid) {
    switch (result_.obstruction) {
      case PlanObstruction::kNone:
        return Fault("there is no motion, and no reason is given");
      case PlanObstruction::kGoalBlocked:
        if (!ground_.IsBlocked(goal_)) Fault("the goal is not blocked");
        return;
      case PlanObstruction::kGoalUnreachable:
        if (laid && MeetTheGoal(*laid)) Fault("the goal is in the part of the free ground in which the cable lies");
        return;
      case PlanObstruction::kStartBlocked:
      case PlanObstruction::kLaidCableBlocked:
        if (laid || laid.error().obstruction != result_.obstruction) return Fault("the cable is not blocked so");
        for (std::string& fault : BlockedFaults(planner_, tether_, result_.obstruction)) Fault(std::move(fault));
        return;
      case PlanObstruction::kLaidCableTooLong:
        if (result_.start.length <= result_.limit) Fault("the laid cable is not too long");
        return;
      case PlanObstruction::kTetherTooShort:
        if (!result_.shortest_tether) Fault("the tether that the goal needs is missing");
        return;
      case PlanObstruction::kMustCross:
        if (!FindCurveCrossing(result_.start.points)) Fault("the laid cable crosses itself nowhere");
        return;
    }
  }

  /// Whether one component of the free ground holds the whole cable and the goal.
  bool MeetTheGoal(const LaidCable& laid) const {
    std::vector<std::size_t> common = ground_.ComponentsAt(goal_);
    Polyline cable = tether_.laid.value_or(Polyline{tether_.base});
    cable[0] = laid.socket.exit.point;
    for (const Point p : cable) {
      const std::vector<std::size_t> here = ground_.ComponentsAt(p);
      std::erase_if(common, [&here](std::size_t i) { return std::find(here.begin(), here.end(), i) == here.end(); });
    }
    return !common.empty();
  }

  /// The path of the answer: shortest in its class, or, around the base, its two parts.
  void CheckPath(const Motion& motion, const std::string& name) {
    const auto base = std::find(motion.path.points.begin(), motion.path.points.end(), tether_.base);
    const bool is_answer = result_.motion && &motion == &*result_.motion;
    if (!is_answer || !result_.crossing_free || !result_.crossing_free->around_base) {
      return CheckCurve(motion.path, name, in_socket_);
    }
    if (base == motion.path.points.end()) return Fault(name + " does not come to the base");
    const TautSpace& space = planner_.space();
    CheckCurve(space.MakePath(Polyline(motion.path.points.begin(), base + 1)), name + " to the base", false);
    CheckCurve(space.MakePath(Polyline(base, motion.path.points.end())), name + " from the base", false);
  }

  void CheckMotion(const Motion& motion, const std::string& name, bool must_fit) {
    CheckPath(motion, name + "'s path");
    CheckCurve(motion.tether, name + "'s tether", stub_);
    const Polyline& path = motion.path.points;
    if (path.empty() || motion.tether.points.empty()) return;
    if (!Near(path.front(), result_.start.points.back())) Fault(name + " does not start where the robot is");
    if (!Near(path.back(), goal_)) Fault(name + " does not end at the goal");
    if (!Near(motion.tether.points.back(), goal_)) Fault(name + "'s tether does not end at the goal");
    if (!Near(motion.tether.points.front(), tether_.base)) Fault(name + "'s tether does not start at the base");
    const Word expected = ground_.WordOf(result_.start.points) * ground_.WordOf(path);
    if (ground_.WordOf(motion.tether.points) != expected) {
      Fault(name + "'s tether is not in the class that the path leaves behind");
    }
    if (must_fit && motion.tether.length > result_.limit * (1 + kLengthTolerance)) {
      Fault(name + "'s tether is too long");
    }
  }

  /// The tether at evenly spaced places of the path, proposed by the engine, certified here.
  void CheckAlong(const LaidCable& laid, const TautPath& path, int samples) {
    std::optional<Walk> walk = laid.walk;
    Polyline passed = result_.start.points;
    std::size_t next = in_socket_ ? 2 : 1;
    for (int k = 1; k < samples; ++k) {
      const double target = path.length * k / samples;
      double at = in_socket_ ? Distance(path.points[0], path.points[1]) : 0;
      if (target < at) continue;
      std::size_t i = in_socket_ ? 2 : 1;
      while (i < path.points.size() && at + Distance(path.points[i - 1], path.points[i]) < target) {
        at += Distance(path.points[i - 1], path.points[i]);
        ++i;
      }
      if (i >= path.points.size()) break;
      for (; next < i; ++next) Advance(path.points[next], walk, passed);
      const double leg = Distance(path.points[i - 1], path.points[i]);
      Advance(Lerp(path.points[i - 1], path.points[i], (target - at) / leg), walk, passed);
      CheckSample(laid, *walk, passed);
    }
  }

  void Advance(Point to, std::optional<Walk>& walk, Polyline& passed) {
    const Point leg[] = {to};
    if (planner_.space().Follow(leg, walk)) Fault("the path leaves the free space on the way");
    passed.push_back(walk->at);
  }

  void CheckSample(const LaidCable& laid, const Walk& walk, const Polyline& passed) {
    ++verification_.samples;
    const TautPath tether = planner_.TetherAlong(laid.socket, walk);
    CheckCurve(tether, "the tether on the way", stub_);
    if (ground_.WordOf(tether.points) != ground_.WordOf(passed)) {
      Fault("the tether on the way is not in the class of the path so far");
    }
    if (tether.length > result_.limit * (1 + kLengthTolerance)) Fault("the tether is too long on the way");
    if (result_.crossing_free && !TouchesItself(tether.points) && FindCurveCrossing(tether.points)) {
      Fault("the tether crosses itself on the way");
    }
  }

  /// Whether the free end touches an earlier part of the cable, with the robot, or over the base: then rounding alone
  /// tells on which side of it.
  bool TouchesItself(const Polyline& tether) const {
    const std::size_t n = tether.size();
    if (n < 3) return false;
    const double tolerance = planner_.space().tolerance();
    if (DistanceToSegment(tether[0], tether[n - 2], tether[n - 1]) <= tolerance) return true;
    for (std::size_t i = 0; i + 2 < n; ++i) {
      if (DistanceToSegment(tether.back(), tether[i], tether[i + 1]) <= tolerance) return true;
    }
    return false;
  }

  void CheckShortestTether(bool has_stub) {
    CheckCurve(*result_.shortest_tether, "the shortest tether", has_stub);
    if (!Near(result_.shortest_tether->points.front(), tether_.base) ||
        !Near(result_.shortest_tether->points.back(), goal_)) {
      Fault("the shortest tether does not run from the base to the goal");
    }
    if (result_.shortest_tether->length <= result_.limit) Fault("the tether named as too long fits");
  }

  const TetherPlanner& planner_;
  const FreeSpace& space_;
  RingGround ground_;
  const Tether& tether_;
  Point goal_;
  const PlanResult& result_;
  Verification verification_;
  bool stub_ = false;
  bool in_socket_ = false;
};

}  // namespace

std::vector<std::string> LaidCableFaults(const TetherPlanner& planner, const Tether& tether, const LaidCable& laid,
                                         const TautPath& taut) {
  const FreeSpace& space = planner.space().free_space();
  const bool has_stub = laid.socket.stub_length > 0 && taut.points.size() > 1;
  std::vector<std::string> faults = CurveFaults(space, taut, has_stub ? &planner.ungrown_space() : nullptr);
  Polyline as_laid = tether.laid.value_or(Polyline{tether.base});
  if (has_stub) as_laid.insert(as_laid.begin() + 1, laid.socket.exit.point);
  const RingGround ground(space);
  const bool same_class = ground.WordOf(as_laid) == ground.WordOf(taut.points);
  if (!same_class) faults.emplace_back("is not in the class of the laid cable");
  return faults;
}

std::vector<std::string> BlockedFaults(const TetherPlanner& planner, const Tether& tether,
                                       PlanObstruction obstruction) {
  const RingGround ground(planner.space().free_space()), ungrown(planner.ungrown_space());
  const auto socket = FindSocket(planner.space(), planner.ungrown(), tether.base);
  if (!socket) {
    if (!ground.IsBlocked(tether.base)) return {"the base is not blocked"};
    for (const FreeComponent& component : planner.space().free_space().components) {
      for (const Point exit : component.outer.points) {
        if (ungrown.SurelyHolds(Polyline{tether.base, exit})) return {"a way leads out of the socket"};
      }
    }
    return {};
  }
  if (obstruction == PlanObstruction::kStartBlocked) {
    if (!tether.laid || !ground.IsBlocked(tether.laid->back())) return {"the robot does not stand on blocked ground"};
    return {};
  }
  Polyline cable = tether.laid.value_or(Polyline{tether.base});
  cable[0] = socket->exit.point;
  if (ground.SurelyHolds(cable)) return {"the laid cable does not leave the free ground"};
  return {};
}

Verification VerifyPlan(const TetherPlanner& planner, const Tether& tether, Point goal, const PlanResult& result,
                        const VerifyOptions& options) {
  return Verifier(planner, tether, goal, result).Run(options);
}

}  // namespace tautline
