// How far it is to a goal along taut curves, from every directed edge of the visibility graph.
#ifndef TAUTLINE_HOMOTOPY_GOAL_FIELD_H_
#define TAUTLINE_HOMOTOPY_GOAL_FIELD_H_

#include <optional>
#include <vector>

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

/// Exact taut distances to one goal.
class GoalField {
 public:
  /// One Dijkstra over the directed edges, backwards from the goal, which may be reached through any sector. `limit`:
  /// distances beyond it are infinite.
  GoalField(const TautSpace& space, Place goal, double limit);

  /// Where all distances end.
  Place goal() const { return goal_; }

  /// The least length from the head of the edge to the goal over walks that go on from the edge with taut turns;
  /// infinite when there is none within the limit.
  double Beyond(EdgeId edge) const { return beyond_[edge.index()]; }

  /// The length of the last leg from the corner to the goal when a walk may end with it after touching the corner
  /// with its obstacle on side `head`, coming from `from`; nothing otherwise.
  std::optional<double> LastLeg(CornerId corner, Side head, Point from) const;

 private:
  const TautSpace* space_;
  Place goal_;
  std::vector<double> beyond_;
  std::vector<TautLeg> leg_;  ///< By corner; side kNone where the goal is not in tangent sight.
};

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_GOAL_FIELD_H_
