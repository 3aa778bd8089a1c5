#include "tautline/planners/tether/class_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "tautline/base/check.h"

namespace tautline {
namespace {

/// A taut path from the robot to a corner. Until it shares its last edge with the tether it carries the tether's walk.
struct Label {
  CornerId corner;
  Side head = Side::kNone;
  EdgeId edge;        ///< The last edge; invalid for the first leg from the robot.
  double path = 0;    ///< Metres from the robot.
  double tether = 0;  ///< Metres from the base; known once settled.
  std::int64_t parent = -1;
  std::optional<Walk> walk;  ///< Of the tether; empty once merged.
};

struct Candidate {
  double total;  ///< The least length of any path to the goal through this label.
  std::int64_t label;
  bool finished;  ///< The label's path goes straight on to the goal (-1: straight from the robot).

  friend bool operator>(const Candidate& a, const Candidate& b) { return a.total > b.total; }
};

class ClassChoiceSearch {
 public:
  ClassChoiceSearch(const TautSpace& space, const Walk& laid, const GoalField& field, const ClassChoiceOptions& options)
      : space_(space),
        laid_(laid),
        field_(field),
        options_(options),
        least_tether_(space.graph().edges().size(), std::numeric_limits<double>::infinity()) {}

  ClassChoice Run() {
    Start();
    ClassChoice choice;
    while (!queue_.empty()) {
      if (++choice.labels > options_.budget) {
        choice.budget_exceeded = true;
        break;
      }
      const Candidate candidate = queue_.top();
      queue_.pop();
      if (candidate.finished) {
        if (GoalTether(candidate) > options_.max_tether) continue;
        choice.path = PointsOf(candidate.label);
        break;
      }
      if (Settle(candidate.label)) Extend(candidate.label);
    }
    return choice;
  }

 private:
  Label& At(std::int64_t label) { return labels_[static_cast<std::size_t>(label)]; }
  Point PointAt(CornerId id) const { return space_.corners()[id].point; }
  Point Before(const Label& label) { return label.parent < 0 ? laid_.at : PointAt(At(label.parent).corner); }
  const Walk& WalkBefore(const Label& label) { return label.parent < 0 ? laid_ : *At(label.parent).walk; }

  void Start() {
    Walk straight = laid_;
    if (!WalkStraight(space_.mesh(), field_.goal().point, straight)) {
      queue_.push({Distance(laid_.at, field_.goal().point), -1, true});
    }
    const Place robot{laid_.at, laid_.sleeve.back()};
    for (const TautLeg& leg : LegsFrom(space_, robot)) {
      // A first leg has no directed edge, hence no exact distance beyond it; zero is a lower bound.
      Push({leg.corner, leg.side, {}, leg.length, 0, -1, {}}, leg.length);
    }
  }

  void Push(Label label, double total) {
    labels_.push_back(std::move(label));
    queue_.push({total, static_cast<std::int64_t>(labels_.size()) - 1, false});
  }

  /// Finds the label's tether; false when it is too long or no better than that of a shorter path over the same edge.
  bool Settle(std::int64_t position) {
    Label& label = At(position);
    const bool merged = label.parent >= 0 && !At(label.parent).walk;
    if (merged) {
      label.tether = At(label.parent).tether + space_.graph().edge(label.edge).length;
    } else {
      PullTether(label);
    }
    if (label.tether > options_.max_tether) return false;
    if (label.walk || !label.edge.valid()) return true;
    if (label.tether + field_.Beyond(label.edge) > options_.max_tether) return false;
    double& least = least_tether_[label.edge.index()];
    if (label.tether >= least) return false;
    least = label.tether;
    return true;
  }

  /// Carries the tether along the label's last leg and pulls it taut; drops the walk when both now end alike.
  void PullTether(Label& label) {
    Walk walk = WalkBefore(label);
    TAUTLINE_CHECK(!WalkStraight(space_.mesh(), PointAt(label.corner), walk));
    const TautCurve tether = PullTaut(space_.mesh(), walk);
    label.tether = tether.length;
    const std::size_t n = tether.points.size();
    if (n >= 2 && tether.points[n - 2].point == Before(label)) return;
    label.walk = std::move(walk);
  }

  void Extend(std::int64_t position) {
    const Point before = Before(At(position));
    const CornerId corner = At(position).corner;
    const Side head = At(position).head;
    const double path = At(position).path;
    if (const auto leg = field_.LastLeg(corner, head, before)) queue_.push({path + *leg, position, true});
    const auto out = space_.graph().OutOf(corner);
    for (std::size_t k = 0; k < out.size(); ++k) {
      const EdgeId edge(space_.graph().First(corner).index() + k);
      const double beyond = field_.Beyond(edge);
      if (out[k].tail != head || !std::isfinite(beyond)) continue;
      if (!IsTautTurn(before, PointAt(corner), head, PointAt(out[k].to))) continue;
      const double longer = path + out[k].length;
      Push({out[k].to, out[k].head, edge, longer, 0, position, {}}, longer + beyond);
    }
  }

  double GoalTether(const Candidate& candidate) {
    const Point goal = field_.goal().point;
    if (candidate.label >= 0 && !At(candidate.label).walk) {
      const Label& label = At(candidate.label);
      return label.tether + Distance(PointAt(label.corner), goal);
    }
    Walk walk = candidate.label < 0 ? laid_ : *At(candidate.label).walk;
    TAUTLINE_CHECK(!WalkStraight(space_.mesh(), goal, walk));
    return PullTaut(space_.mesh(), walk).length;
  }

  Polyline PointsOf(std::int64_t label) {
    Polyline points{field_.goal().point};
    for (; label >= 0; label = At(label).parent) points.push_back(PointAt(At(label).corner));
    if (points.size() > 1 || laid_.at != field_.goal().point) points.push_back(laid_.at);
    std::reverse(points.begin(), points.end());
    return points;
  }

  const TautSpace& space_;
  const Walk& laid_;
  const GoalField& field_;
  ClassChoiceOptions options_;
  std::vector<double> least_tether_;  ///< By edge, over settled merged labels.
  std::vector<Label> labels_;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
};

}  // namespace

ClassChoice ChooseClass(const TautSpace& space, const Walk& laid, const GoalField& field,
                        const ClassChoiceOptions& options) {
  return ClassChoiceSearch(space, laid, field, options).Run();
}

}  // namespace tautline
