#include "tautline/planners/tether/verify_plan.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "tautline/geometry/polygon.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

template <class Visit>
void ForEachRing(const FreeSpace& space, Visit visit) {
  for (const FreeComponent& component : space.components) {
    visit(component.outer.points);
    for (const BoundaryRing& hole : component.holes) visit(hole.points);
  }
}

template <class Visit>
void ForEachEdge(const FreeSpace& space, Visit visit) {
  ForEachRing(space, [&visit](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
  });
}

/// Whether the segment stays in the closed free space, up to a depth of `tolerance`: it is cut where it meets
/// boundaries, and the middle of every piece must be free.
bool SegmentIsFree(const FreeSpace& space, Point a, Point b, double tolerance) {
  std::vector<double> cuts{0, 1};
  ForEachEdge(space, [&](Point p, Point q) {
    const double side_p = Cross(b - a, p - a), side_q = Cross(b - a, q - a);
    if ((side_p > 0 && side_q > 0) || (side_p < 0 && side_q < 0) || side_p == side_q) return;
    const Point meet = Lerp(p, q, side_p / (side_p - side_q));
    const double at = Dot(meet - a, b - a) / Dot(b - a, b - a);
    if (at > 0 && at < 1) cuts.push_back(at);
  });
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if (!ComponentOf(space, Lerp(a, b, 0.5 * (cuts[i - 1] + cuts[i])), tolerance)) return false;
  }
  return true;
}

/// Whether a curve a-b-c bends at b around blocked ground: b is a boundary vertex whose blocked cone lies between the
/// two arms, on the inner side of the bend.
bool BendsAroundObstacle(const FreeSpace& space, Point a, Point b, Point c) {
  const int turn = Orientation(a, b, c);
  bool around = false;
  ForEachRing(space, [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size() && !around; ++i) {
      if (ring[i] != b) continue;
      const Point before = ring[(i + ring.size() - 1) % ring.size()], after = ring[(i + 1) % ring.size()];
      const auto on_inner_side = [&](Point p, Point q, Point r) { return Orientation(p, q, r) * turn >= 0; };
      around = turn != 0 && on_inner_side(a, b, before) && on_inner_side(a, b, after) && on_inner_side(b, c, before) &&
               on_inner_side(b, c, after);
    }
  });
  return around;
}

/// The reduced word by the definition, ray by ray: for each segment the rays between its ends in order of travel.
Word CountedWord(const FreeSpace& space, std::span<const Point> curve) {
  Word word;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const Point p = curve[i - 1], q = curve[i];
    const bool rightward = p.x < q.x;
    std::vector<std::pair<double, ObstacleId>> crossed;
    for (std::size_t k = 0; k < space.islands.size(); ++k) {
      const Point ray = space.islands[k].representative;
      if ((p.x < ray.x) == (q.x < ray.x)) continue;
      if (Orientation(rightward ? p : q, rightward ? q : p, ray) < 0) crossed.emplace_back(ray.x, ObstacleId(k));
    }
    std::sort(crossed.begin(), crossed.end());
    if (!rightward) std::reverse(crossed.begin(), crossed.end());
    for (const auto& [x, island] : crossed) word.Append({island, !rightward});
  }
  return word;
}

bool SameLength(double a, double b) { return std::fabs(a - b) <= kLengthTolerance * std::max({1.0, std::fabs(a)}); }

/// Runs the checks and collects what they find.
class Verifier {
 public:
  Verifier(const TetherPlanner& planner, const Tether& tether, Point goal, const PlanResult& result)
      : planner_(planner), space_(planner.space().free_space()), tether_(tether), goal_(goal), result_(result) {}

  Verification Run(const VerifyOptions& options) {
    const auto laid = planner_.FollowLaidCable(tether_);
    if (result_.shortest_tether) CheckShortestTether(laid && laid->socket.stub_length > 0);
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
    for (const std::string& fault : CurveFaults(space_, path, has_stub)) {
      Fault(std::string(name).append(" ").append(fault));
    }
  }

  bool Near(Point a, Point b) const { return Distance(a, b) <= 2 * planner_.space().tolerance(); }

  void CheckStart(const LaidCable& laid) {
    CheckCurve(result_.start, "the tether at the start", stub_ && !in_socket_);
    Polyline as_laid = tether_.laid.value_or(Polyline{tether_.base});
    if (stub_ && !in_socket_) as_laid.insert(as_laid.begin() + 1, laid.socket.exit.point);
    if (CountedWord(space_, as_laid) != CountedWord(space_, result_.start.points)) {
      Fault("the tether at the start is not in the class of the laid cable");
    }
  }

  void CheckMotion(const Motion& motion, const std::string& name, bool must_fit) {
    CheckCurve(motion.path, name + "'s path", in_socket_);
    CheckCurve(motion.tether, name + "'s tether", stub_);
    const Polyline& path = motion.path.points;
    if (path.empty() || motion.tether.points.empty()) return;
    if (!Near(path.front(), result_.start.points.back())) Fault(name + " does not start where the robot is");
    if (!Near(path.back(), goal_)) Fault(name + " does not end at the goal");
    if (!Near(motion.tether.points.back(), goal_)) Fault(name + "'s tether does not end at the goal");
    if (!Near(motion.tether.points.front(), tether_.base)) Fault(name + "'s tether does not start at the base");
    const Word expected = CountedWord(space_, result_.start.points) * CountedWord(space_, path);
    if (CountedWord(space_, motion.tether.points) != expected) {
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
    if (CountedWord(space_, tether.points) != CountedWord(space_, passed)) {
      Fault("the tether on the way is not in the class of the path so far");
    }
    if (tether.length > result_.limit * (1 + kLengthTolerance)) Fault("the tether is too long on the way");
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
  const Tether& tether_;
  Point goal_;
  const PlanResult& result_;
  Verification verification_;
  bool stub_ = false;
  bool in_socket_ = false;
};

}  // namespace

std::vector<std::string> CurveFaults(const FreeSpace& space, const TautPath& path, bool has_stub) {
  std::vector<std::string> faults;
  const Polyline& points = path.points;
  if (points.empty()) return {"has no points"};
  const double tolerance = BoundaryTolerance(space);
  const std::size_t first = has_stub ? 1 : 0;
  for (std::size_t i = first; i + 1 < points.size(); ++i) {
    if (points[i] == points[i + 1]) {
      faults.emplace_back("repeats a point");
    } else if (!SegmentIsFree(space, points[i], points[i + 1], tolerance)) {
      faults.emplace_back("leaves the free space");
    }
  }
  for (std::size_t i = first + 1; i + 1 < points.size(); ++i) {
    if (!BendsAroundObstacle(space, points[i - 1], points[i], points[i + 1])) {
      faults.emplace_back("is not taut at bend " + std::to_string(i));
    }
  }
  if (!SameLength(Length(points), path.length)) faults.emplace_back("has another length than it claims");
  if (CountedWord(space, points) != path.word) faults.emplace_back("has another word than it claims");
  return faults;
}

Verification VerifyPlan(const TetherPlanner& planner, const Tether& tether, Point goal, const PlanResult& result,
                        const VerifyOptions& options) {
  return Verifier(planner, tether, goal, result).Run(options);
}

}  // namespace tautline
