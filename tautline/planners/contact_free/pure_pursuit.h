// A robot that follows a path by steering at a point a little ahead of it.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_PURE_PURSUIT_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_PURE_PURSUIT_H_

#include <vector>

#include "tautline/geometry/polygon.h"
#include "tautline/planners/contact_free/driven_motion.h"

namespace tautline {

/// How the robot drives.
struct PurePursuitOptions {
  double speed_m_per_s = 1;   ///< Going straight. Positive.
  double turn_rad_per_s = 2;  ///< At most; where the arc is tighter the robot goes slower. Positive.
  double dt_s = 0.1;          ///< For which a command holds. Positive.
};

/// Follows one path: the robot steers along the arc to the point of the path that lies the lookahead ahead of where it
/// is [Coulter1992], and turns on the spot when that point is behind it. Keeps how far along the path it is, so that a
/// path may cross itself.
class PurePursuit {
 public:
  /// Requires a path of a point or more.
  explicit PurePursuit(Polyline path, const PurePursuitOptions& options = {});

  /// Moves on along the path to the place nearest to the robot, no farther ahead than `reach_m`. O(points passed).
  void MoveOn(Point robot, double reach_m);

  /// Where to drive from a pose, with a lookahead; a command without motion when the robot is at the end. Requires a
  /// positive lookahead. O(points within it).
  Velocity Steer(const RobotPose& pose, double lookahead_m) const;

  /// Turns on the spot towards the same point; no motion when the robot looks at it, or is there.
  Velocity TurnTowards(const RobotPose& pose, double lookahead_m) const;

 private:
  Point PointAt(double along_m) const;
  static double AngleTo(const RobotPose& pose, Point target);

  Polyline path_;
  PurePursuitOptions options_;
  std::vector<double> reached_m_;  ///< The length of the path up to each of its points.
  double along_m_ = 0;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_PURE_PURSUIT_H_
