// Every constant of environment and learner by its name: for the command line, for files, for messages.
#ifndef APPS_ANSWERS_LEARN_OPTIONS_H_
#define APPS_ANSWERS_LEARN_OPTIONS_H_

#include <optional>
#include <string>

#include "apps/answers/json_values.h"
#include "tautline/base/error.h"
#include "tautline/planners/contact_free/training_run.h"

namespace tautline {

/// What a policy is trained with. Radius and links are decided by ResolveBody.
struct LearnOptions {
  TetherEnvOptions env;
  TrainingOptions training;
};

/// Calls visit(name, number, help) for each constant of the environment; names are those of options, with `_`.
template <class Options, class Visit>
void VisitEnvOptions(Options& env, const Visit& visit) {
  visit("robot_radius", env.robot_radius_m, "of the robot's disc, metres; otherwise the scene's, or 0.5");
  visit("link", env.link_length_m, "the length of a link of the cable, metres; otherwise twice the radius");
  visit("speed", env.speed_m_per_s, "of the robot straight on, metres per second");
  visit("turn_rate", env.turn_rad_per_s, "of the robot on the spot, radians per second");
  visit("dt", env.dt_s, "a step of the environment, seconds");
  visit("goal_radius", env.goal_radius_m, "the goal is reached within this, metres");
  visit("max_steps", env.max_steps, "steps after which an episode is cut");
  visit("grid", env.grid_m, "to which observed positions are rounded, metres");
  visit("grid_heading", env.grid_rad, "to which observed headings are rounded, radians");
  visit("start_noise", env.start_noise_m, "the start of an episode is moved by up to this, metres");
  visit("heading_noise", env.heading_noise_rad, "the heading at the start is turned by up to this, radians");
  visit("reward_goal", env.reward.goal, "for reaching the goal");
  visit("reward_robot_obstacle", env.reward.robot_obstacle, "for hitting an obstacle");
  visit("reward_cable_obstacle", env.reward.cable_obstacle, "for a step with the cable at an obstacle");
  visit("reward_cable_robot", env.reward.cable_robot, "for a step with the cable under the robot");
  visit("reward_rotation", env.reward.rotation, "for a step on the spot");
  visit("reward_time", env.reward.time, "for every step");
  visit("reward_progress", env.reward.progress, "shared among the way-points of the reference");
  visit("reward_deviation", env.reward.deviation, "for each metre off the reference, beyond the threshold");
  visit("deviation_from", env.reward.deviation_from_radii, "that threshold, robot radii");
}

/// The same for the learner.
template <class Options, class Visit>
void VisitDqnOptions(Options& dqn, const Visit& visit) {
  visit("steps", dqn.steps, "of the environment, in all");
  visit("learning_rate", dqn.learning_rate, "of Adam");
  visit("discount", dqn.discount, "of what the next step is worth");
  visit("buffer", dqn.buffer, "steps that are remembered");
  visit("batch", dqn.batch, "remembered steps in a gradient step");
  visit("target_interval", dqn.target_interval, "steps after which the target network is renewed");
  visit("learning_starts", dqn.learning_starts, "steps at random before the first gradient step");
  visit("train_frequency", dqn.train_frequency, "steps between those of the gradient");
  visit("gradient_steps", dqn.gradient_steps, "so many then");
  visit("exploration_fraction", dqn.exploration_fraction, "share of the steps over which exploration falls");
  visit("exploration_initial", dqn.exploration_initial, "share of random actions at first");
  visit("exploration_final", dqn.exploration_final, "share of random actions in the end");
  visit("max_gradient_norm", dqn.max_gradient_norm, "longer gradients are made this long");
}

/// Radius and links, in this order of precedence: what was given here, the scene's radius, the defaults. Links are
/// twice the radius where nothing else is said. Not positive: not given.
void ResolveBody(const Scene& scene, double robot_radius_m, double link_length_m, TetherEnvOptions& env);

/// All constants by their names, and the seed.
Json ToJson(const LearnOptions& options);

/// The constants of the environment as ToJson wrote them. Errors, with `name`: one is missing or of another type.
[[nodiscard]] Expected<TetherEnvOptions> EnvOptionsFrom(const std::string& text, const std::string& name);

}  // namespace tautline

#endif  // APPS_ANSWERS_LEARN_OPTIONS_H_
