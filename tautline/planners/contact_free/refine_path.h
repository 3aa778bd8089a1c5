// A path bent bit by bit so that tracking it costs less.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_REFINE_PATH_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_REFINE_PATH_H_

#include <vector>

#include "tautline/base/stop.h"
#include "tautline/planners/contact_free/track_path.h"

namespace tautline {

/// How a path is refined.
struct RefinePathOptions {
  double per_metre = 0.2;                               ///< What a metre driven costs, besides minus the rewards.
  double spacing_m = 0.7;                               ///< Between the points that are moved. Positive.
  std::vector<double> steps_m = {0.4, 0.2, 0.1, 0.05};  ///< By how much, coarse to fine.
  int rounds = 3;                                       ///< With each, at most, while there is something to gain.
  KeepGoing keep_going = {};  ///< Asked before each trial; at a no the best so far is returned.
};

/// A path and what tracking it comes to.
struct RefinedPath {
  Polyline path;      ///< From the robot on.
  TrackResult track;  ///< Of it.
  double cost = 0;    ///< Of the track; infinite where it does not reach the goal.
};

/// Leaves out points of a path, moves the others sideways, along and to between their neighbours, and keeps what makes
/// the tracked robot's cost less: what a bend does to the cable long after it is counted in full. An environment whose
/// rewards count the goal or the reference would count them. Requires a path of a point or more from where the robot
/// stands. Deterministic. O(points * steps * rounds) drives.
RefinedPath RefinePath(const TetherEnv& env, const Polyline& path, const RefinePathOptions& options = {});

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_REFINE_PATH_H_
