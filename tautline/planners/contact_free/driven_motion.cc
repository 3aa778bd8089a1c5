#include "tautline/planners/contact_free/driven_motion.h"

#include <cmath>

namespace tautline {

std::array<Velocity, 9> BasicVelocities(const TetherEnvOptions& options) {
  const double speed = options.speed_m_per_s, turn = options.turn_rad_per_s;
  return {Velocity{speed, 0},
          {speed, 0.25 * turn},
          {speed, -0.25 * turn},
          {speed, 0.5 * turn},
          {speed, -0.5 * turn},
          {speed, turn},
          {speed, -turn},
          {0, turn},
          {0, -turn}};
}

Polyline DrivenMotion::Path() const {
  Polyline path;
  for (const RobotPose& pose : poses) {
    // Steps that turn on the spot stay where they are.
    if (path.empty() || path.back() != pose.at) path.push_back(pose.at);
  }
  return path;
}

void AddStep(const Velocity& velocity, const EnvStep& outcome, const TetherEnvOptions& options, MotionCosts& costs) {
  const RewardOptions& worth = options.reward;
  const bool turns = velocity.speed_m_per_s == 0 && velocity.turn_rad_per_s != 0;
  ++costs.steps;
  costs.turning_steps += turns ? 1 : 0;
  costs.cable_obstacle_steps += outcome.cable_obstacle ? 1 : 0;
  costs.cable_robot_steps += outcome.cable_robot ? 1 : 0;
  if (!outcome.held && !outcome.robot_obstacle) costs.length_m += std::abs(velocity.speed_m_per_s) * options.dt_s;
  costs.penalty -= worth.time;
  if (turns) costs.penalty -= worth.rotation;
  if (outcome.cable_obstacle) costs.penalty -= worth.cable_obstacle;
  if (outcome.cable_robot) costs.penalty -= worth.cable_robot;
  if (outcome.robot_obstacle) costs.penalty -= worth.robot_obstacle;
}

DrivenMotion DriveMotion(const TetherEnv& env, std::span<const Velocity> velocities) {
  TetherEnv driven = env;
  DrivenMotion motion;
  const auto record = [&] {
    motion.poses.push_back(driven.pose());
    const auto nodes = driven.cable().nodes();
    motion.cables.emplace_back(nodes.begin(), nodes.end());
  };
  record();
  for (const Velocity& velocity : velocities) {
    const EnvStep outcome = driven.StepWith(velocity.speed_m_per_s, velocity.turn_rad_per_s);
    AddStep(velocity, outcome, driven.options(), motion.costs);
    motion.velocities.push_back(velocity);
    motion.outcomes.push_back(outcome);
    record();
    motion.at_goal = outcome.at_goal;
    if (outcome.ends() || outcome.held) break;
  }
  return motion;
}

}  // namespace tautline
