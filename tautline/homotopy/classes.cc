#include "tautline/homotopy/classes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include "tautline/homotopy/goal_field.h"

namespace tautline {
namespace {

/// By how much the radius of a field grows when it was too small: first by this share of itself, then by ever more.
constexpr double kFirstGrowth = 0.03;
constexpr double kFasterGrowth = 1.5;
constexpr int kStepsPerCheck = 1024;
/// The share of the radius that rounding could fake.
constexpr double kLeastGrowth = 1e-9;

/// One taut walk from the start to the head of an edge or leg, as a link to the walk before it.
struct Stem {
  CornerId corner;  ///< Where it stands.
  Side head = Side::kNone;
  std::int32_t parent = -1;
  EdgeRange onward;
  double length = 0;  ///< From the start to the corner.
};

/// A walk to extend, or a finished one.
struct Candidate {
  double total;       ///< The least length of any walk to the goal that it leads to.
  std::int32_t stem;  ///< -1: straight from the start to the goal.
  bool finished;

  /// By total; equal ones in the order in which they were found, whatever the heap makes of them.
  friend bool operator>(const Candidate& a, const Candidate& b) {
    return std::tie(a.total, a.stem, a.finished) > std::tie(b.total, b.stem, b.finished);
  }
};

bool IsStraight(const TautSpace& space, const Walk& start, Point to) {
  Walk straight = start;
  return !WalkStraight(space.mesh(), to, straight);
}

class ClassSearch {
 public:
  ClassSearch(const TautSpace& space, const Walk& start, Place to, const ClassOptions& options)
      : space_(space),
        start_(start),
        from_(start.at),
        options_(options),
        limit_(options.max_length ? *options.max_length * (1 + kLengthTolerance)
                                  : std::numeric_limits<double>::infinity()),
        field_(space, to, {.keep_going = options.keep_going}),
        stop_(options.keep_going, kStepsPerCheck) {}

  ClassList Run() {
    ClassList list;
    try {
      List(list);
    } catch (const Stopped&) {
      list.budget_exceeded = true;
    }
    list.complete = !list.budget_exceeded && queue_.empty();
    SortTies(list.classes);
    return list;
  }

 private:
  void List(ClassList& list) {
    field_.GrowTo(limit_);
    Start();
    const std::int64_t most = options_.max_count.value_or(std::numeric_limits<std::int64_t>::max());
    while (!queue_.empty() && static_cast<std::int64_t>(list.classes.size()) < most) {
      if (expanded_ >= options_.budget) {
        list.budget_exceeded = true;
        break;
      }
      const Candidate candidate = queue_.top();
      queue_.pop();
      if (candidate.finished) {
        ++expanded_;
        stop_.Step();
        list.classes.push_back(space_.MakePath(PointsOf(candidate.stem)));
      } else {
        Follow(candidate);
      }
    }
  }

  Point PointAt(CornerId id) const { return space_.corners()[id].point; }

  void Start() {
    const Point goal = field_.goal().point;
    if (IsStraight(space_, start_, goal)) Offer({Distance(from_, goal), -1, true});
    for (const FirstLeg& first : FirstLegsFrom(space_, start_)) {
      stems_.push_back({first.leg.corner, first.leg.side, -1, first.onward, first.leg.length});
      if (const auto next = Extend(LastStem())) Offer(*next);
    }
  }

  std::int32_t LastStem() const { return static_cast<std::int32_t>(stems_.size()) - 1; }

  void Offer(const Candidate& candidate) {
    if (candidate.total <= limit_) queue_.push(candidate);
  }

  /// Extends a walk along its best way on, and so on, as long as no other candidate is better.
  void Follow(Candidate candidate) {
    while (!candidate.finished && expanded_ < options_.budget) {
      ++expanded_;
      stop_.Step();
      const auto next = Extend(candidate.stem);
      if (!next) return;
      candidate = *next;
      if (!queue_.empty() && queue_.top().total < candidate.total) break;
    }
    queue_.push(candidate);
  }

  /// Offers all taut continuations of a stem that lead to the goal within the limit, but the best, which it returns.
  std::optional<Candidate> Extend(std::int32_t position) {
    const Stem stem = stems_[static_cast<std::size_t>(position)];
    std::optional<Candidate> best;
    const auto offer = [&](Candidate candidate) {
      if (candidate.total > limit_) return;
      if (!best) {
        best = candidate;
        return;
      }
      if (candidate.total < best->total) std::swap(*best, candidate);
      queue_.push(candidate);
    };
    if (const auto leg = field_.LastLeg(stem.corner, stem.head, Before(stem))) {
      offer({stem.length + *leg, position, true});
    }
    for (EdgeId id = stem.onward.first; id < stem.onward.last; ++id) {
      const TautEdge& edge = space_.graph().edge(id);
      const double length = stem.length + edge.length, total = length + field_.Beyond(id);
      if (total > limit_ || !std::isfinite(total)) continue;
      stems_.push_back({edge.to, edge.head, position, space_.graph().Onward(id), length});
      offer({total, LastStem(), false});
    }
    return best;
  }

  Point Before(const Stem& stem) const {
    return stem.parent < 0 ? from_ : PointAt(stems_[static_cast<std::size_t>(stem.parent)].corner);
  }

  Polyline PointsOf(std::int32_t stem) const {
    Polyline points{field_.goal().point};
    for (; stem >= 0; stem = stems_[static_cast<std::size_t>(stem)].parent) {
      points.push_back(PointAt(stems_[static_cast<std::size_t>(stem)].corner));
    }
    if (points.size() > 1 || from_ != field_.goal().point) points.push_back(from_);
    std::reverse(points.begin(), points.end());
    return points;
  }

  /// Classes whose lengths are equal but for rounding go by word.
  static void SortTies(std::vector<TautPath>& classes) {
    for (auto begin = classes.begin(); begin != classes.end();) {
      const double most = begin->length * (1 + kLengthTolerance);
      const auto end = std::find_if(begin, classes.end(), [most](const TautPath& c) { return c.length > most; });
      std::sort(begin, end, [](const TautPath& a, const TautPath& b) {
        return std::pair(a.word.size(), a.word) < std::pair(b.word.size(), b.word);
      });
      begin = end;
    }
  }

  const TautSpace& space_;
  const Walk& start_;
  Point from_;
  ClassOptions options_;
  double limit_;
  GoalField field_;
  std::vector<Stem> stems_;
  std::int64_t expanded_ = 0;
  StopCheck stop_;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
};

/// The shortest path that is not straight: along the exact distances, down to the goal.
class ShortestDescent {
 public:
  ShortestDescent(const TautSpace& space, const Walk& start, const GoalDistances& field)
      : space_(space), field_(field), from_(start.at), legs_(FirstLegsFrom(space, start)) {}

  std::optional<Polyline> Run() {
    if (legs_.empty()) return std::nullopt;
    Step step = BestStart();
    if (!std::isfinite(step.total)) return std::nullopt;
    Polyline points{from_};
    while (step.corner.valid()) {
      const Point before = points.back();
      points.push_back(PointAt(step.corner));
      step = BestAfter(before, step);
    }
    points.push_back(field_->goal().point);
    return points;
  }

 private:
  /// To which corner a walk goes next, and how far it is to the goal that way; straight to the goal without a corner.
  struct Step {
    double total = std::numeric_limits<double>::infinity();
    CornerId corner;
    Side head = Side::kNone;
    EdgeRange onward;
  };

  Point PointAt(CornerId id) const { return space_.corners()[id].point; }

  /// Grows the field until no start that it does not know could be better.
  Step BestStart() const {
    double radius = Distance(from_, field_->goal().point), growth = kFirstGrowth * radius;
    for (;;) {
      field_.GrowTo(radius);
      const Step best = BestKnownStart();
      const double missing = best.total - LeastUnknown();
      if (field_->complete() || missing <= 0) return best;
      radius += std::clamp(missing, kLeastGrowth * radius, growth);
      growth *= kFasterGrowth;
    }
  }

  /// No path that the field does not know yet is shorter.
  double LeastUnknown() const {
    double least = std::numeric_limits<double>::infinity();
    for (const FirstLeg& first : legs_) {
      least = std::min(least, first.leg.length + field_->LeastUnknown(first.leg.corner));
    }
    return least;
  }

  Step BestKnownStart() const {
    Step best;
    for (const auto& [leg, onward] : legs_) {
      const Step step{leg.length, leg.corner, leg.side, onward};
      const double total = leg.length + BestAfter(from_, step).total;
      if (total < best.total) best = {total, leg.corner, leg.side, onward};
    }
    return best;
  }

  Step BestAfter(Point before, const Step& at) const {
    Step best;
    if (const auto leg = field_->LastLeg(at.corner, at.head, before)) best.total = *leg;
    for (EdgeId id = at.onward.first; id < at.onward.last; ++id) {
      const TautEdge& edge = space_.graph().edge(id);
      const double total = edge.length + field_->Beyond(id);
      if (total < best.total) best = {total, edge.to, edge.head, space_.graph().Onward(id)};
    }
    return best;
  }

  const TautSpace& space_;
  const GoalDistances& field_;
  Point from_;
  std::vector<FirstLeg> legs_;
};

}  // namespace

ClassList FindClasses(const TautSpace& space, Point from, Point to, const ClassOptions& options) {
  const auto start = space.Locate(from), goal = space.Locate(to);
  if (!start || !goal || !space.mesh().Connected(*start, *goal)) return {{}, true, false};
  return FindClassesOnward(space, Walk(*start), *goal, options);
}

ClassList FindClassesOnward(const TautSpace& space, const Walk& walk, Place to, const ClassOptions& options) {
  return ClassSearch(space, walk, to, options).Run();
}

std::optional<TautPath> FindShortestOnward(const TautSpace& space, const Walk& walk, Place to) {
  if (!space.mesh().Connected({walk.at, walk.sleeve.back()}, to)) return std::nullopt;
  GoalField field(space, to, {.targets = {walk.at}});
  auto points = FindShortestOnward(space, walk, GoalDistances(field));
  if (!points) return std::nullopt;
  return space.MakePath(*std::move(points));
}

std::optional<Polyline> FindShortestOnward(const TautSpace& space, const Walk& walk, const GoalDistances& field) {
  const Point goal = field->goal().point;
  if (IsStraight(space, walk, goal)) return walk.at == goal ? Polyline{goal} : Polyline{walk.at, goal};
  return ShortestDescent(space, walk, field).Run();
}

}  // namespace tautline
