// A policy at work: one episode in which the robot always does what seems best.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_POLICY_RUN_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_POLICY_RUN_H_

#include <vector>

#include "tautline/network/mlp.h"
#include "tautline/planners/contact_free/tether_env.h"

namespace tautline {

/// What an episode came to.
struct EpisodeTotals {
  double reward = 0;       ///< The sum, not discounted.
  bool success = false;    ///< The goal was reached.
  bool hit = false;        ///< The robot hit an obstacle.
  int steps = 0;           ///< Of the environment.
  int cable_robot = 0;     ///< Steps after which the robot stood on its cable.
  int cable_obstacle = 0;  ///< Steps after which the cable touched an obstacle.
  double length_m = 0;     ///< How far the robot's centre went.

  /// Counts a step that moved the robot so far.
  void Add(const EnvStep& step, double moved_m);
  /// A count of steps as contacts a minute of simulated time; 0 for no time. [Shimada2024, Sec. 6.2]
  double PerMinute(int count, double dt_s) const;
};

/// One moment of an episode.
struct EnvFrame {
  double t_s = 0;               ///< Since the start.
  RobotPose pose;               ///< Of the robot.
  Polyline cable;               ///< From base to tail.
  bool cable_robot = false;     ///< The robot stands on its cable.
  bool cable_obstacle = false;  ///< The cable touches an obstacle.
};

/// An episode.
struct PolicyRun {
  EpisodeTotals totals;          ///< What it came to.
  std::vector<EnvFrame> frames;  ///< The start and each step; empty where they were not wanted.

  /// The robot's places, without those at which it only turns. Requires frames.
  Polyline Path() const;
};

/// Plays one episode from the environment's start to its end, greedily: the first of the actions whose values are
/// largest. Requires a network of three inputs and three outputs. O(steps * weights).
PolicyRun RunPolicy(TetherEnv env, const Mlp& network, const Kernels& kernels, bool keep_frames);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_POLICY_RUN_H_
