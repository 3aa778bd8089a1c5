// A path driven by the simulated robot with its cable: how all paths are compared.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_TRACK_PATH_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_TRACK_PATH_H_

#include <vector>

#include "tautline/planners/contact_free/pure_pursuit.h"

namespace tautline {

/// How a path is tracked.
struct TrackPathOptions {
  double lookahead_m = 0.5;  ///< Positive. Half of it is cut off a right angle, nearly.
  /// Where the step would hit an obstacle, or the cable is too short for it, the lookahead is halved up to so often, so
  /// that the robot keeps nearer to its path, and at last the robot turns on the spot; 0: plain pursuit, which fails
  /// there.
  int halvings = 5;
  int cable_every = 0;  ///< Also keep the cable after each so many steps; 0: never.
};

/// How the drive ended.
enum class TrackEnd {
  kAtGoal,       ///< The goal was reached.
  kHitObstacle,  ///< The robot's disc would have touched an obstacle.
  kHeld,         ///< The cable was too short for the next step.
  kOffGoal,      ///< The path ended away from the goal.
  kCut,          ///< The steps of the episode were used up.
};

/// The name of an end in results: "at_goal", "hit_obstacle", "cable_too_short", "off_goal", "time_up".
const char* ToString(TrackEnd end);

/// What a drive came to.
struct TrackResult {
  TrackEnd end = TrackEnd::kOffGoal;  ///< How it ended.
  double driven_m = 0;                ///< How far the robot's centre moved.
  double time_s = 0;                  ///< Simulated.
  int steps = 0;                      ///< Of dt.
  int cable_obstacle_steps = 0;       ///< After which the cable touched an obstacle.
  int cable_robot_steps = 0;          ///< After which the robot stood on its cable.
  double reward = 0;                  ///< The sum of the environment's rewards.
  std::vector<RobotPose> trace;       ///< The robot at the start and after each step.
  std::vector<Velocity> commands;     ///< Of each step.
  std::vector<Polyline> cables;       ///< With TrackPathOptions::cable_every: base first, first the one at the start.

  /// Whether the robot reached the goal.
  bool success() const { return end == TrackEnd::kAtGoal; }
  /// Contacts of a kind by minutes of simulated time [Shimada2024, Sec. 6.2]; 0 for a drive without a step.
  double PerMinute(int contact_steps) const { return steps == 0 ? 0 : 60 * contact_steps / time_s; }
};

/// Drives a robot that stands at the start of its episode along a path until it is at the goal or can go no farther:
/// pure pursuit with the speeds and the time step of the environment [Shimada2024, Sec. 6.2]. Requires a path of a
/// point or more. Deterministic. O(steps * cable nodes).
TrackResult TrackPath(TetherEnv env, const Polyline& path, const TrackPathOptions& options = {});

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_TRACK_PATH_H_
