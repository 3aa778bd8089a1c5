// Positions along the boundary of the ground, as lengths from its first corner.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_OUTLINE_WALK_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_OUTLINE_WALK_H_

#include <optional>
#include <span>
#include <vector>

#include "tautline/geometry/polygon.h"

namespace tautline {

/// A ring that is measured along its edges: position 0 is its first corner, and after the length of the ring the
/// positions start again.
class OutlineWalk {
 public:
  /// Requires three corners or more, neighbours apart. O(n).
  explicit OutlineWalk(Ring ring);

  /// The length of the ring, metres.
  double length() const { return starts_.back(); }

  /// The positions of the corners, ascending from 0, metres.
  std::span<const double> corners() const { return {starts_.data(), starts_.size() - 1}; }

  /// The position from 0 up to, but not including, the length, that is the same place.
  double Wrapped(double position) const;

  /// The point at a position of 0 up to the length; at the position of a corner exactly the corner. O(log n).
  Point At(double position) const;

  /// The position at which the line from one point through another first meets the ring beyond the latter; nothing
  /// where it does not. For choosing places, not for deciding anything: it is rounded. O(n).
  std::optional<double> Beyond(Point from, Point through) const;

  /// The first corner after a position, wrapped. Requires a wrapped position. O(log n).
  double NextCorner(double position) const;

  /// The last corner before a position, wrapped. Requires a wrapped position. O(log n).
  double PreviousCorner(double position) const;

 private:
  Ring ring_;
  std::vector<double> starts_;  ///< Of the edges, and the length.
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_OUTLINE_WALK_H_
