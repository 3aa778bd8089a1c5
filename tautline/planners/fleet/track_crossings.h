// Where the tracks of a playback cross. Internal to the playback.
#ifndef TAUTLINE_PLANNERS_FLEET_TRACK_CROSSINGS_H_
#define TAUTLINE_PLANNERS_FLEET_TRACK_CROSSINGS_H_

#include <array>
#include <span>
#include <vector>

#include "tautline/geometry/polygon.h"
#include "tautline/planners/fleet/fleet_ground.h"

namespace tautline {

/// Two tracks meet in a point.
struct TrackCrossing {
  std::array<RobotId, 2> robots;     ///< The lower one first.
  std::array<double, 2> along = {};  ///< How far along the path of each, metres.
  Point at;                          ///< Where, metres.
};

/// A track and the lengths of the path that it stands for: one of both per point.
struct Track {
  std::span<const Point> points;  ///< Where it turns, metres.
  std::span<const double> along;  ///< How far along the path each is, metres.
};

/// All points where tracks of different robots cross, and those where one ends, or begins, on another. That they meet
/// is decided exactly; where, up to rounding. Tracks that run along each other meet where one of them begins or ends.
/// O(n log n + crossings) for n segments that are not much longer than they are apart.
std::vector<TrackCrossing> FindTrackCrossings(const std::vector<Track>& tracks);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_TRACK_CROSSINGS_H_
