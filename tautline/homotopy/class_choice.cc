#include "tautline/homotopy/class_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "tautline/homotopy/funnel_tree.h"

namespace tautline {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// By how much the radius of the field grows from attempt to attempt: this factor and this share of the tether.
constexpr double kGrowth = 1.03;
constexpr double kLeastGrowth = 0.001;
constexpr int kStepsPerCheck = 512;

using NodeId = FunnelTree::NodeId;

/// A taut path from the robot to a corner. Until it shares its last edge with the tether it carries the tether's class.
struct Label {
  CornerId corner;
  Side head = Side::kNone;
  EdgeId edge;        ///< The last edge; invalid for the first leg from the robot.
  EdgeRange onward;   ///< The taut ways on.
  double path = 0;    ///< Metres from the robot.
  double tether = 0;  ///< Metres from the base; known once settled.
  std::int32_t parent = -1;
  NodeId tether_class;  ///< Of the tether; invalid once merged.

  bool merged() const { return !tether_class.valid(); }
};

/// What to do next with a label.
struct Candidate {
  enum class Kind : std::uint8_t {
    kSettle,  ///< Find its tether, then extend it.
    kExtend,  ///< Extend it by the ways on that the field did not know when it had radius `known`.
    kFinish,  ///< Go straight on to the goal (label -1: straight from the robot).
  };

  double total;  ///< The least length of any path to the goal that comes of it.
  double known;
  std::int32_t label;
  Kind kind;

  /// By total; equal ones in the order in which they were found, whatever the heap makes of them.
  friend bool operator>(const Candidate& a, const Candidate& b) {
    return std::tie(a.total, a.label, a.kind) > std::tie(b.total, b.label, b.kind);
  }
};

class ClassChoiceSearch {
 public:
  ClassChoiceSearch(const TautSpace& space, const Walk& laid, const GoalDistances& field,
                    const ClassChoiceOptions& options)
      : space_(space),
        laid_(laid),
        field_(field),
        options_(options),
        stop_(options.keep_going, kStepsPerCheck),
        tethers_(space.mesh(), laid),
        least_tether_(space.graph().edges().size(), kInfinity) {}

  ClassChoice Run() {
    Start();
    ClassChoice choice;
    while (!queue_.empty()) {
      if (++choice.labels > options_.budget) {
        choice.budget_exceeded = true;
        break;
      }
      stop_.Step();
      const Candidate candidate = queue_.top();
      queue_.pop();
      if (candidate.kind == Candidate::Kind::kFinish) {
        if (GoalTether(candidate) > options_.max_tether) continue;
        choice.path = PointsOf(candidate.label);
        break;
      }
      if (candidate.kind == Candidate::Kind::kExtend) {
        GrowField(candidate.known);
        ExtendBeyond(candidate.known, candidate.label);
      } else if (Settle(candidate.label)) {
        Extend(candidate.label);
      }
    }
    return choice;
  }

 private:
  const Label& At(std::int32_t label) const { return labels_[static_cast<std::size_t>(label)]; }
  Point PointAt(CornerId id) const { return space_.corners()[id].point; }
  Point Before(const Label& label) const { return label.parent < 0 ? laid_.at : PointAt(At(label.parent).corner); }

  void Start() {
    Walk straight = laid_;
    const Point goal = field_->goal().point;
    if (!WalkStraight(space_.mesh(), goal, straight)) {
      queue_.push({Distance(laid_.at, goal), 0, -1, Candidate::Kind::kFinish});
    }
    for (const FirstLeg& first : FirstLegsFrom(space_, laid_)) {
      // A first leg has no directed edge, hence no exact distance beyond it; zero is a lower bound.
      Push({first.leg.corner, first.leg.side, {}, first.onward, first.leg.length, 0, -1, {}}, first.leg.length);
    }
  }

  void GrowField(double known) {
    double radius = kGrowth * known + kLeastGrowth * options_.max_tether;
    if (!(radius > known)) radius = kInfinity;
    field_.GrowTo(radius);
  }

  void Push(const Label& label, double total) {
    labels_.push_back(label);
    queue_.push({total, 0, static_cast<std::int32_t>(labels_.size()) - 1, Candidate::Kind::kSettle});
  }

  /// Finds the label's tether; false when it is too long or no better than that of a shorter path over the same edge.
  bool Settle(std::int32_t position) {
    Label& label = labels_[static_cast<std::size_t>(position)];
    if (label.parent >= 0 && At(label.parent).merged()) {
      label.tether = At(label.parent).tether + space_.graph().edge(label.edge).length;
    } else {
      PullTether(label);
    }
    if (label.tether > options_.max_tether) return false;
    if (!label.merged() || !label.edge.valid()) return true;
    if (label.tether + field_->Beyond(label.edge) > options_.max_tether) return false;
    double& least = least_tether_[label.edge.index()];
    if (label.tether >= least) return false;
    least = label.tether;
    return true;
  }

  /// The class of the tether when the robot goes straight on from the end of a label (-1: from where it stands).
  NodeId TetherClass(std::int32_t from, Point to) {
    if (from < 0) return tethers_.GoStraight(tethers_.trunk(), laid_.at, laid_.is_free_to_turn(), to);
    return tethers_.GoStraight(At(from).tether_class, PointAt(At(from).corner), false, to);
  }

  /// Carries the tether along the label's last leg and pulls it taut; forgets its class when both now end alike.
  void PullTether(Label& label) {
    label.tether_class = TetherClass(label.parent, PointAt(label.corner));
    const FunnelTree::Tether tether = tethers_.Pull(label.tether_class, PointAt(label.corner));
    label.tether = tether.length;
    if (tether.bend == Before(label)) label.tether_class = {};
  }

  void Extend(std::int32_t position) {
    const Label label = At(position);
    if (const auto leg = field_->LastLeg(label.corner, label.head, Before(label))) {
      queue_.push({label.path + *leg, 0, position, Candidate::Kind::kFinish});
    }
    ExtendBeyond(-1, position);
  }

  /// Adds the ways on whose distances the field did not know at radius `known`, and itself again for those that it
  /// does not know yet.
  void ExtendBeyond(double known, std::int32_t position) {
    const Label label = At(position);
    bool all_known = true;
    for (EdgeId id = label.onward.first; id < label.onward.last; ++id) {
      const double beyond = field_->Beyond(id);
      all_known = all_known && std::isfinite(beyond);
      if (std::isinf(beyond) || (known >= 0 && field_->WasKnown(id, known))) continue;
      const TautEdge& edge = space_.graph().edge(id);
      const double longer = label.path + edge.length;
      Push({edge.to, edge.head, id, space_.graph().Onward(id), longer, 0, position, {}}, longer + beyond);
    }
    if (all_known || field_->complete()) return;
    const double total = label.path + field_->LeastUnknown(label.corner);
    queue_.push({total, field_->radius(), position, Candidate::Kind::kExtend});
  }

  double GoalTether(const Candidate& candidate) {
    const Point goal = field_->goal().point;
    if (candidate.label >= 0 && At(candidate.label).merged()) {
      const Label& label = At(candidate.label);
      return label.tether + Distance(PointAt(label.corner), goal);
    }
    return tethers_.Pull(TetherClass(candidate.label, goal), goal).length;
  }

  Polyline PointsOf(std::int32_t label) const {
    Polyline points{field_->goal().point};
    for (; label >= 0; label = At(label).parent) points.push_back(PointAt(At(label).corner));
    if (points.size() > 1 || laid_.at != field_->goal().point) points.push_back(laid_.at);
    std::reverse(points.begin(), points.end());
    return points;
  }

  const TautSpace& space_;
  const Walk& laid_;
  const GoalDistances& field_;
  ClassChoiceOptions options_;
  StopCheck stop_;
  FunnelTree tethers_;
  std::vector<double> least_tether_;  ///< By edge, over settled merged labels.
  std::vector<Label> labels_;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
};

}  // namespace

ClassChoice ChooseClass(const TautSpace& space, const Walk& laid, const GoalDistances& field,
                        const ClassChoiceOptions& options) {
  return ClassChoiceSearch(space, laid, field, options).Run();
}

}  // namespace tautline
