// How far it is to the goal from anywhere, exactly, for a search that asks near the same places again and again.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_GOAL_GUIDE_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_GOAL_GUIDE_H_

#include <memory>
#include <unordered_map>
#include <vector>

#include "tautline/homotopy/goal_field.h"
#include "tautline/homotopy/taut_space.h"

namespace tautline {

/// Taut distances to a goal in a space for the robot's centre: obstacles grown by the robot's radius. A cell of the
/// plane is asked once, at the first place in it that anybody asks about. Remembers; not for several threads at once.
class GoalGuide {
 public:
  /// Keeps a reference to `space`. Requires a positive side of the cells.
  GoalGuide(const TautSpace& space, Place goal, double cell_m);

  /// The length of the shortest path to the goal, metres, less the distance to the place where the cell was asked; less
  /// at corners, by a part of that distance. Infinite outside of the space. O(1), and once a cell O(corners in sight).
  double LowerBound(Point from);

  /// The shortest path itself; empty where there is none.
  Polyline ShortestPath(Point from);

 private:
  struct Asked {
    Point at;
    double distance_m = 0;
  };

  const TautSpace* space_;
  GoalField field_;
  double per_m_;
  std::unordered_map<std::int64_t, Asked> cells_;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_GOAL_GUIDE_H_
