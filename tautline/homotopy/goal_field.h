// How far it is to a goal along taut curves, from every directed edge of the visibility graph.
#ifndef TAUTLINE_HOMOTOPY_GOAL_FIELD_H_
#define TAUTLINE_HOMOTOPY_GOAL_FIELD_H_

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <vector>

#include "tautline/base/check.h"
#include "tautline/base/stop.h"
#include "tautline/homotopy/taut_space.h"

namespace tautline {

/// A tangent from a point to a corner, or, read backwards, the last leg of a taut walk to that point.
struct TautLeg {
  /// The corner that the line touches.
  CornerId corner;
  Side side = Side::kNone;  ///< Of the corner's obstacle, seen from the point.
  double length = 0;        ///< Metres.
};

/// The legs from a place, within its sector, to all corners that it sees along a tangent.
std::vector<TautLeg> LegsFrom(const TautSpace& space, Place place);

/// A first leg of a walk with the taut ways on from its corner.
struct FirstLeg {
  TautLeg leg;       ///< From where the walk stands to a corner.
  EdgeRange onward;  ///< From that corner.
};

/// The first legs of paths that go on from where a walk stands: on a vertex where blocked ground touches they leave
/// within the sector that the walk came in by, or, when it has not moved yet and is not rooted, by any.
std::vector<FirstLeg> FirstLegsFrom(const TautSpace& space, const Walk& walk);

/// How a goal field grows.
struct GoalFieldOptions {
  /// Where searches will start: the field grows towards the nearest of these points; without any, evenly.
  std::vector<Point> targets;
  /// Asked while the field grows; when it says stop, GrowTo throws Stopped.
  KeepGoing keep_going;
};

/// Exact taut distances to one goal, found outwards from the goal as far as they are asked for. Once complete, it is
/// immutable and serves many starts in several threads.
class GoalField {
 public:
  /// Knows the legs to the goal, and no distance yet.
  explicit GoalField(const TautSpace& space, Place goal, GoalFieldOptions options = {});

  /// Finds the distances of all edges that lie on walks from a target (without targets: of all edges) up to `radius`
  /// metres from the goal, and perhaps of some more. A* over the directed edges backwards, continued from call to call;
  /// each edge is looked at once and no turn is tested: O(e log e) for e edges in all.
  void GrowTo(double radius);

  /// How far the field has grown, metres; infinite when it is complete.
  double radius() const { return radius_; }
  /// Every distance is known, and what is not known does not exist.
  bool complete() const { return radius_ == std::numeric_limits<double>::infinity(); }

  /// No way from the corner to the goal that is not known yet is shorter than this, metres; it may be negative.
  double LeastUnknown(CornerId corner) const { return radius_ - ToTarget(corner); }

  /// Where all distances end.
  const Place& goal() const { return goal_; }

  /// The least length from the head of the edge to the goal over walks that go on from the edge with taut turns;
  /// infinite when it is not known yet or, in a complete field, when there is none.
  double Beyond(EdgeId edge) const { return beyond_[space_->graph().edge(edge).reverse.index()]; }

  /// Whether Beyond(edge) was known when the field had that radius.
  bool WasKnown(EdgeId edge, double radius) const {
    return Beyond(edge) + ToTarget(space_->graph().edge(edge).to) <= radius;
  }

  /// The length of the last leg from the corner to the goal when a walk may end with it after touching the corner
  /// with its obstacle on side `head`, coming from `from`; nothing otherwise.
  std::optional<double> LastLeg(CornerId corner, Side head, Point from) const;

 private:
  /// A way from a corner to the goal: over an edge, or, counted from -1 down, along a leg.
  struct Entry {
    double total;  ///< From the nearest target straight to the corner, and on to the goal.
    double distance;
    std::int32_t source;

    friend bool operator>(const Entry& a, const Entry& b) {
      return a.total > b.total || (a.total == b.total && a.source > b.source);
    }
  };

  double ToTarget(CornerId corner) const;
  void Push(CornerId from, double distance, std::int32_t source);
  void Settle(const Entry& entry);
  template <class CanTurn>
  void ReachInto(StanceId stance, double distance, CanTurn can_turn);

  const TautSpace* space_;
  Place goal_;
  std::vector<Point> targets_;
  StopCheck stop_;
  double radius_ = 0;
  std::vector<double> beyond_;  ///< By the reverses of the edges, which lie together at the corner where they end.
  std::vector<TautLeg> legs_;
  std::vector<std::int32_t> leg_at_;  ///< By corner; -1 where the goal is not in tangent sight.
  /// By stance: the end of those edges that leave the opposite stance whose reverses have no distance yet, and the
  /// first edge that the last of these reverses can turn into; invalid and past all edges when there are none.
  std::vector<EdgeId> open_end_;
  std::vector<EdgeId> open_from_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

/// A goal field as a search uses it: its own, grown as far as the search asks, or a complete one that others share.
class GoalDistances {
 public:
  /// Grows `own`, which must outlive this.
  explicit GoalDistances(GoalField& own) : field_(&own), own_(&own) {}
  /// Requires that `shared` is complete and outlives this.
  explicit GoalDistances(const GoalField& shared) : field_(&shared) { TAUTLINE_CHECK(shared.complete()); }

  /// The field.
  const GoalField& operator*() const { return *field_; }
  /// A member of the field.
  const GoalField* operator->() const { return field_; }

  /// As GoalField::GrowTo; a complete field stays as it is.
  void GrowTo(double radius) const {
    if (own_ != nullptr) own_->GrowTo(radius);
  }

 private:
  const GoalField* field_;
  GoalField* own_ = nullptr;
};

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_GOAL_FIELD_H_
