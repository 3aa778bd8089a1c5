// A motion of the robot with its cable, step by step: what it costs in the environment, and what comes of it.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_DRIVEN_MOTION_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_DRIVEN_MOTION_H_

#include <array>
#include <span>
#include <vector>

#include "tautline/planners/contact_free/tether_env.h"

namespace tautline {

/// What the robot is told for one step of the environment.
struct Velocity {
  double speed_m_per_s = 0;   ///< Forwards.
  double turn_rad_per_s = 0;  ///< Counter-clockwise.

  /// Whether both parts are equal.
  friend bool operator==(const Velocity&, const Velocity&) = default;
};

/// Straight on, arcs of three radii to either side, turns on the spot: what searches and policies choose among.
std::array<Velocity, 9> BasicVelocities(const TetherEnvOptions& options);

/// What some steps cost: minus the rewards of the environment, without those for goal and reference.
struct MotionCosts {
  int steps = 0;                 ///< All of them.
  int turning_steps = 0;         ///< On the spot.
  int cable_obstacle_steps = 0;  ///< After which the cable touched an obstacle.
  int cable_robot_steps = 0;     ///< After which the robot stood on its cable.
  double length_m = 0;           ///< Driven.
  double penalty = 0;            ///< Contacts, turning and time. [Shimada2024, Eq. 2]

  /// Contacts of either kind a minute; 0 where there is no step.
  double PerMinute(int contact_steps, double dt_s) const {
    return steps == 0 ? 0 : 60 * contact_steps / (dt_s * steps);
  }
};

/// A motion and what comes of it.
struct DrivenMotion {
  std::vector<Velocity> velocities;  ///< One a step.
  std::vector<RobotPose> poses;      ///< Where it starts, and after each step.
  std::vector<Polyline> cables;      ///< From base to tail, at the same times.
  std::vector<EnvStep> outcomes;     ///< Of each step.
  MotionCosts costs;                 ///< Of all steps.
  bool at_goal = false;              ///< It ends there.

  /// The way of the robot's centre.
  Polyline Path() const;
};

/// Adds a step with its outcome. O(1).
void AddStep(const Velocity& velocity, const EnvStep& outcome, const TetherEnvOptions& options, MotionCosts& costs);

/// Drives a motion in a copy of the environment, from its state on, and stops where the episode ends, or at a step that
/// moves nothing. O(steps).
DrivenMotion DriveMotion(const TetherEnv& env, std::span<const Velocity> velocities);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_DRIVEN_MOTION_H_
