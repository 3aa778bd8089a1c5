#include "tautline/planners/contact_free/driver_policy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "tautline/base/check.h"
#include "tautline/network/onnx_file.h"

namespace tautline {
namespace {

/// What is lost by hitting an obstacle or being held, for the look ahead: more than contacts can cost.
constexpr double kEndOfTheWay = 100;

/// What the choice costs over the next steps, straight on after the first where it turns on the spot.
double CostAhead(TetherEnv env, const Velocity& velocity, int steps) {
  double cost = 0;
  for (int k = 0; k < steps; ++k) {
    const EnvStep step = env.StepWith(velocity.speed_m_per_s, velocity.turn_rad_per_s);
    // The sooner, the worse.
    if (step.robot_obstacle || step.held) return cost + kEndOfTheWay * (steps - k) / steps;
    if (step.at_goal) return cost;
    cost += (step.cable_obstacle ? -env.options().reward.cable_obstacle : 0) +
            (step.cable_robot ? -env.options().reward.cable_robot : 0);
    if (step.cut) break;
  }
  return cost / steps;
}

}  // namespace

std::array<Velocity, kDriverChoices> DriverChoices(const TetherEnvOptions& options) {
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

int ChoiceOf(const Velocity& velocity, const TetherEnvOptions& options) {
  const auto choices = DriverChoices(options);
  const auto off = [&](const Velocity& choice) {
    return std::abs(choice.speed_m_per_s - velocity.speed_m_per_s) / std::max(1e-9, options.speed_m_per_s) +
           std::abs(choice.turn_rad_per_s - velocity.turn_rad_per_s) / std::max(1e-9, options.turn_rad_per_s);
  };
  const auto best = std::min_element(choices.begin(), choices.end(),
                                     [&](const Velocity& a, const Velocity& b) { return off(a) < off(b); });
  return static_cast<int>(best - choices.begin());
}

DriverPolicy::DriverPolicy(const Mlp& network, const Kernels& kernels, const DriverOptions& options)
    : network_(network), pass_(network.widths(), 1, kernels), options_(options) {
  TAUTLINE_CHECK(network.inputs() == kViewSize && network.outputs() == kDriverChoices);
}

Expected<DriverPolicy> DriverPolicy::Read(std::string_view bytes, const std::string& name, const Kernels& kernels,
                                          const DriverOptions& options) {
  const auto model = ReadOnnx(bytes, name);
  if (!model) return tl::unexpected(model.error());
  if (model->network.inputs() != kViewSize || model->network.outputs() != kDriverChoices) {
    return InvalidInput("a network of " + std::to_string(model->network.inputs()) + " inputs and " +
                            std::to_string(model->network.outputs()) +
                            " outputs is no policy for all maps, which has " + std::to_string(kViewSize) + " and " +
                            std::to_string(kDriverChoices) + ": take one that `learn imitate` wrote",
                        name);
  }
  return DriverPolicy(model->network, kernels, options);
}

int DriverPolicy::Choose(const TetherEnv& env, std::size_t waypoint) {
  const DriverView view = LookAround(env, waypoint);
  const std::span<const float> values = pass_.Forward(network_, view);
  const auto choices = DriverChoices(env.options());
  int best = 0;
  double best_value = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < kDriverChoices; ++k) {
    double value = values[static_cast<std::size_t>(k)];
    if (options_.look_ahead_steps > 0) {
      value -= options_.caution * CostAhead(env, choices[static_cast<std::size_t>(k)], options_.look_ahead_steps);
    }
    if (value > best_value) best = k, best_value = value;
  }
  return best;
}

DrivenMotion DriverPolicy::Drive(TetherEnv env) {
  const TetherEnv start = env;
  const auto choices = DriverChoices(env.options());
  std::vector<Velocity> velocities;
  std::size_t waypoint = 0;
  for (EnvStep step; !step.ends() && !step.held;) {
    waypoint = AdvanceAlong(env, waypoint);
    velocities.push_back(choices[static_cast<std::size_t>(Choose(env, waypoint))]);
    step = env.StepWith(velocities.back().speed_m_per_s, velocities.back().turn_rad_per_s);
  }
  return DriveMotion(start, velocities);
}

}  // namespace tautline
