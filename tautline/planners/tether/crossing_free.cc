#include "tautline/planners/tether/crossing_free.h"

#include <algorithm>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/geometry/curve_crossing.h"
#include "tautline/geometry/predicates.h"
#include "tautline/homotopy/classes.h"
#include "tautline/planners/tether/explain.h"

namespace tautline {

/// The ground that the end of the tether sweeps on a shortest path: a pseudo-triangle.
struct CrossingFreeSearch::Swept {
  Polyline trunk;        ///< What the tethers at both ends share, base first.
  Polyline side;         ///< The part of the path that bounds the ground.
  std::size_t next = 0;  ///< Which point of the path comes after the first one of the side.
  Ring ring;             ///< Fewer than three points when it has no interior.

  static Swept Between(const Polyline& start, const Polyline& path, const Polyline& end);

  /// Whether the tether enters it from the base, and leaves it across the path.
  bool entered() const;
};

namespace {

/// Two curves from one point on: what they share, up to where they part, and the rest of each from there.
struct Parting {
  Polyline shared, first, second;
  std::size_t second_next = 0;  ///< Which of its own points the second one comes to next after parting.
};

Parting Part(std::span<const Point> a, std::span<const Point> b) {
  std::size_t n = 0;
  while (n < a.size() && n < b.size() && a[n] == b[n]) ++n;
  TAUTLINE_CHECK(n > 0);
  Parting parting{{a.begin(), a.begin() + static_cast<std::ptrdiff_t>(n)}, {}, {}};
  // On from the last common vertex, one may bend, or end, on a straight part of the other.
  if (n < a.size() && n < b.size()) {
    if (OnSegment(a[n - 1], b[n], a[n])) {
      parting.shared.push_back(a[n]);
    } else if (OnSegment(a[n - 1], a[n], b[n])) {
      parting.shared.push_back(b[n]);
    }
  }
  const auto next = [&](std::span<const Point> curve) {
    return n < curve.size() && curve[n] == parting.shared.back() ? n + 1 : n;
  };
  const auto rest = [&](std::span<const Point> curve) {
    Polyline points{parting.shared.back()};
    points.insert(points.end(), curve.begin() + static_cast<std::ptrdiff_t>(next(curve)), curve.end());
    return points;
  };
  parting.first = rest(a);
  parting.second = rest(b);
  parting.second_next = next(b);
  return parting;
}

Polyline Reversed(const Polyline& points) { return {points.rbegin(), points.rend()}; }

Polyline Points(const TautCurve& curve) {
  Polyline points;
  for (const TautPoint& p : curve.points) points.push_back(p.point);
  return points;
}

}  // namespace

CrossingFreeSearch::Swept CrossingFreeSearch::Swept::Between(const Polyline& start, const Polyline& path,
                                                             const Polyline& end) {
  Parting tethers = Part(start, end);
  // The path runs along the tether at the start first, and along the one at the end last.
  const Parting away = Part(Reversed(tethers.first), path);
  const Parting home = Part(Reversed(tethers.second), Reversed(away.second));
  Swept swept{std::move(tethers.shared), Reversed(home.second), away.second_next, {}};
  if (swept.side.size() < 2) return swept;
  swept.ring = swept.side;
  const auto append = [&swept](Polyline::const_iterator first, Polyline::const_iterator last) {
    swept.ring.insert(swept.ring.end(), first, last);
  };
  // Onwards from the end of the side to where the tethers part, and from there to its start.
  append(home.first.begin() + 1, home.first.end());
  const Polyline out = Reversed(away.first);
  if (out.size() > 1) append(out.begin() + 1, out.end() - 1);
  if (swept.ring.size() > 1 && swept.ring.back() == swept.ring.front()) swept.ring.pop_back();
  return swept;
}

bool CrossingFreeSearch::Swept::entered() const {
  if (ring.size() < 3) return false;
  for (std::size_t i = 0; i + 1 < trunk.size(); ++i) {
    if (EntersRing(ring, trunk[i], trunk[i + 1])) return true;
  }
  return false;
}

bool CrossingFreeSearch::CrossesOnTheWay(const Polyline& start, const Polyline& path, const Polyline& end) {
  return Swept::Between(start, path, end).entered();
}

double RetreatLength(const TautPath& start, const TautPath& end) {
  return start.length + end.length - 2 * Length(Part(start.points, end.points).shared);
}

CrossingFreeSearch::CrossingFreeSearch(const TetherPlanner& planner, const LaidCable& laid, Place goal,
                                       const PlanOptions& options, PlanResult& result)
    : planner_(planner), laid_(laid), goal_(goal), options_(options), result_(result) {}

/// The shortest crossing-free motion of the class of a path, if there is one that the tether allows.
std::optional<CrossingFreeSearch::Candidate> CrossingFreeSearch::Examine(const Polyline& path) const {
  Motion motion = planner_.MotionAlong(laid_, path);
  if (motion.tether.length > result_.limit * (1 + kLengthTolerance)) return std::nullopt;
  if (FindCurveCrossing(motion.tether.points)) return std::nullopt;
  const Swept swept = Swept::Between(result_.start.points, motion.path.points, motion.tether.points);
  if (!swept.entered()) return Candidate{std::move(motion)};
  return AroundBase(motion, swept);
}

/// To the base and on from there, in the class of a motion whose path the tether crosses.
CrossingFreeSearch::Candidate CrossingFreeSearch::AroundBase(const Motion& motion, const Swept& swept) const {
  const auto meeting = FindFirstMeeting(swept.trunk, swept.side);
  TAUTLINE_CHECK(meeting);
  // The swept ground is free, so the ways over the place where tether and path meet are of the right classes.
  Polyline slit(swept.trunk.begin(), swept.trunk.begin() + static_cast<std::ptrdiff_t>(meeting->on_curve) + 1);
  if (slit.back() != meeting->at) slit.push_back(meeting->at);
  const Polyline& path = motion.path.points;
  const auto next = path.begin() + static_cast<std::ptrdiff_t>(swept.next + meeting->on_other);
  Polyline there(path.begin(), next), onwards(slit);
  there.insert(there.end(), slit.rbegin(), slit.rend());
  onwards.insert(onwards.end(), next, path.end());
  const TautSpace& space = planner_.space();
  std::optional<Walk> walk{Walk(laid_.robot())};
  TAUTLINE_CHECK(!space.Follow(there, walk));
  std::optional<Walk> walk_on{Walk(Place{walk->at, walk->sleeve.back()})};
  TAUTLINE_CHECK(!space.Follow(onwards, walk_on));
  Polyline points = Points(PullTaut(space.mesh(), *walk));
  const Polyline second = Points(PullTaut(space.mesh(), *walk_on));
  points.insert(points.end(), second.begin() + 1, second.end());
  return {Motion{space.MakePath(std::move(points)), motion.tether}, true};
}

void CrossingFreeSearch::Offer(std::optional<Candidate> candidate) {
  if (!candidate) return;
  if (!best_ || candidate->motion.path.length < best_->motion.path.length) best_ = std::move(candidate);
}

/// The path of the class in which the robot drives back along its cable and out along a curve from the exit of the
/// socket.
Polyline CrossingFreeSearch::OutAlong(const Polyline& tether) const {
  const Polyline back = Reversed(Points(PullTaut(planner_.space().mesh(), laid_.walk)));
  std::optional<Walk> walk{Walk(laid_.robot())};
  TAUTLINE_CHECK(!planner_.space().Follow(back, walk) && !planner_.space().Follow(tether, walk));
  return Points(PullTaut(planner_.space().mesh(), *walk));
}

/// Examines the classes in the order of their shortest paths, until these are longer than the best motion. Whether that
/// came about within the budget.
bool CrossingFreeSearch::SearchClasses() {
  constexpr std::int64_t kFirstCount = 8, kGrowth = 4;
  constexpr std::int64_t kStepsPerClass = 50;  // An examined class takes as long as about so many steps.
  const std::int64_t most = std::max<std::int64_t>(1, options_.budget / kStepsPerClass);
  for (std::int64_t count = std::min(kFirstCount, most);; count = std::min(kGrowth * count, most)) {
    const double beyond = best_->motion.path.length * (1 - kLengthTolerance);
    const ClassList list = FindClassesOnward(planner_.space(), laid_.walk, goal_,
                                             {.max_length = best_->motion.path.length,
                                              .max_count = count,
                                              .budget = options_.budget,
                                              .keep_going = options_.keep_going});
    examined_ = 0;
    for (const TautPath& path : list.classes) {
      if (path.length >= std::min(beyond, best_->motion.path.length * (1 - kLengthTolerance))) return true;
      ++examined_;
      Offer(Examine(path.points));
      bound_ = std::max(bound_, path.length);
    }
    if (list.complete) return true;
    if (list.budget_exceeded || count == most) return false;
  }
}

void CrossingFreeSearch::Report(bool optimal) {
  const double length = best_->motion.path.length;
  CrossingFree facts{.classes_examined = std::max<std::int64_t>(1, examined_),
                     .optimal = optimal,
                     .bound = optimal ? length : std::min(bound_, length),
                     .retreat_length = RetreatLength(result_.start, best_->motion.tether),
                     .around_base = best_->around_base,
                     .plain = {}};
  if (result_.motion && result_.motion->path.points != best_->motion.path.points) facts.plain = result_.motion;
  result_.motion = std::move(best_->motion);
  result_.crossing_free = std::move(facts);
  result_.status = PlanStatus::kSolved;
  result_.explanation.clear();
}

void CrossingFreeSearch::Run(const Polyline& shortest) {
  if (const auto crossing = FindCurveCrossing(result_.start.points)) {
    result_.motion.reset();
    result_.rejected.reset();
    result_.status = PlanStatus::kInfeasible;
    result_.obstruction = PlanObstruction::kMustCross;
    result_.explanation = ExplainMustCross(*crossing);
    return;
  }
  if (result_.motion) {
    // The search by length would come to the motion that may cross through all those that are too long.
    const Polyline& path = result_.motion->path.points;
    Offer(laid_.in_socket ? Candidate{*result_.motion} : Examine(path));
    bound_ = result_.motion->path.length;
    if (best_ && !best_->around_base) return Report(true);
  } else if (result_.rejected) {
    bound_ = result_.rejected->path.length;
  }
  Offer(Examine(OutAlong(shortest)));
  TAUTLINE_CHECK(best_);
  Report(SearchClasses());
}

}  // namespace tautline
