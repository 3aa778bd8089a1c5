#include "tautline/homotopy/classes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "tautline/homotopy/goal_field.h"

namespace tautline {
namespace {

/// Lengths that agree this closely, relative to the larger, are equal for limits and for the order of classes.
constexpr double kLengthTolerance = 1e-9;

/// One taut walk from the start to the head of an edge or leg, as a link to the walk before it.
struct Stem {
  CornerId corner;  ///< Where it stands.
  Side head = Side::kNone;
  double length = 0;  ///< From the start to the corner.
  std::int64_t parent = -1;
};

/// A walk to extend (`stem` valid), or a finished one that ended at the goal from `stem` (-1: straight).
struct Candidate {
  double total;  ///< The least length of any walk to the goal that it leads to.
  std::int64_t stem;
  bool finished;

  friend bool operator>(const Candidate& a, const Candidate& b) { return a.total > b.total; }
};

/// The sectors into which a path may go on.
std::vector<Place> StartSectors(const FreeMesh& mesh, const Walk& start) {
  const Place here{start.at, start.sleeve.back()};
  return start.is_free_to_turn() ? mesh.Sectors(here) : std::vector<Place>{here};
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
        field_(space, to, limit_) {}

  ClassList Run() {
    Start();
    ClassList list;
    const std::int64_t most = options_.max_count.value_or(std::numeric_limits<std::int64_t>::max());
    std::int64_t expanded = 0;
    while (!queue_.empty() && static_cast<std::int64_t>(list.classes.size()) < most) {
      if (++expanded > options_.budget) {
        list.budget_exceeded = true;
        break;
      }
      const Candidate candidate = queue_.top();
      queue_.pop();
      if (candidate.finished) {
        list.classes.push_back(space_.MakePath(PointsOf(candidate.stem)));
      } else {
        Extend(candidate.stem);
      }
    }
    list.complete = queue_.empty();
    SortTies(list.classes);
    return list;
  }

  /// Follows the exact distances from the start down to the goal.
  std::optional<TautPath> Shortest() {
    Continuation best = Straight();
    for (const Place& sector : StartSectors(space_.mesh(), start_)) {
      for (const TautLeg& leg : LegsFrom(space_, sector)) {
        const double total = leg.length + BestAfter(from_, leg.corner, leg.side).total;
        if (total < best.total) best = {total, leg.corner, leg.side};
      }
    }
    if (!std::isfinite(best.total)) return std::nullopt;
    Polyline points{from_};
    while (best.corner.valid()) {
      const Point before = points.back();
      points.push_back(PointAt(best.corner));
      best = BestAfter(before, best.corner, best.head);
    }
    if (points.back() != field_.goal().point) points.push_back(field_.goal().point);
    return space_.MakePath(std::move(points));
  }

 private:
  /// Where a shortest walk goes next, and how far it is to the goal that way; straight to the goal without a corner.
  struct Continuation {
    double total = std::numeric_limits<double>::infinity();
    CornerId corner;
    Side head = Side::kNone;
  };

  Continuation Straight() const {
    Walk straight = start_;
    if (WalkStraight(space_.mesh(), field_.goal().point, straight)) return {};
    return {Distance(from_, field_.goal().point), {}, Side::kNone};
  }

  Continuation BestAfter(Point before, CornerId corner, Side head) const {
    Continuation best;
    if (const auto leg = field_.LastLeg(corner, head, before)) best.total = *leg;
    const auto out = space_.graph().OutOf(corner);
    for (std::size_t k = 0; k < out.size(); ++k) {
      const double total = out[k].length + field_.Beyond(EdgeId(space_.graph().First(corner).index() + k));
      if (out[k].tail != head || total >= best.total) continue;
      if (IsTautTurn(before, PointAt(corner), head, PointAt(out[k].to))) best = {total, out[k].to, out[k].head};
    }
    return best;
  }

  Point PointAt(CornerId id) const { return space_.corners()[id].point; }

  void Start() {
    if (const Continuation straight = Straight(); std::isfinite(straight.total)) Offer(straight.total, -1, true);
    for (const Place& sector : StartSectors(space_.mesh(), start_)) {
      for (const TautLeg& leg : LegsFrom(space_, sector)) {
        const auto stem = static_cast<std::int64_t>(stems_.size());
        stems_.push_back({leg.corner, leg.side, leg.length, -1});
        Extend(stem);
      }
    }
  }

  void Offer(double total, std::int64_t stem, bool finished) {
    if (total <= limit_) queue_.push({total, stem, finished});
  }

  /// Adds all taut continuations of a stem that lead to the goal within the limit.
  void Extend(std::int64_t position) {
    const Stem stem = stems_[static_cast<std::size_t>(position)];
    const Point before = stem.parent < 0 ? from_ : PointAt(stems_[static_cast<std::size_t>(stem.parent)].corner);
    const Point here = PointAt(stem.corner);
    if (const auto leg = field_.LastLeg(stem.corner, stem.head, before)) Offer(stem.length + *leg, position, true);
    const auto out = space_.graph().OutOf(stem.corner);
    for (std::size_t k = 0; k < out.size(); ++k) {
      const TautEdge& edge = out[k];
      const double beyond = field_.Beyond(EdgeId(space_.graph().First(stem.corner).index() + k));
      const double length = stem.length + edge.length;
      if (edge.tail != stem.head || length + beyond > limit_ || !std::isfinite(beyond)) continue;
      if (!IsTautTurn(before, here, stem.head, PointAt(edge.to))) continue;
      stems_.push_back({edge.to, edge.head, length, position});
      Offer(length + beyond, static_cast<std::int64_t>(stems_.size()) - 1, false);
    }
  }

  Polyline PointsOf(std::int64_t stem) const {
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
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
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
  return ClassSearch(space, walk, to, {}).Shortest();
}

}  // namespace tautline
