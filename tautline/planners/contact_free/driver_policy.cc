#include "tautline/planners/contact_free/driver_policy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "tautline/base/check.h"
#include "tautline/network/onnx_file.h"

namespace tautline {
namespace {

/// What is lost by hitting an obstacle or being held, for the look ahead: more than contacts can cost.
constexpr double kEndOfTheWay = 100;
/// A point that is farther to the side than this, or behind, is turned to on the spot.
constexpr double kTurnFrom = 0.45 * std::numbers::pi;
/// A velocity that is tried is kept for so many steps; then the reference is followed.
constexpr int kHeldSteps = 4;
/// The reference is followed towards the way-point that is so many after the nearest one.
constexpr std::size_t kWaypointsAhead = 2;
/// A robot that has not come nearer to the goal along its reference for so many steps follows the reference itself for
/// half as many.
constexpr int kPatience = 60;

double AngleTo(const RobotPose& pose, Point p) {
  const Point off = p - pose.at;
  return std::remainder(std::atan2(off.y, off.x) - pose.heading_rad, 2 * std::numbers::pi);
}

/// Along the arc to the point [Coulter1992], no tighter than the robot turns at its speed.
Velocity Pursue(const RobotPose& pose, Point p, const TetherEnvOptions& options) {
  const double angle = AngleTo(pose, p), turn = options.turn_rad_per_s;
  if (std::abs(angle) > kTurnFrom) return {0, angle > 0 ? turn : -turn};
  const double curvature = 2 * std::sin(angle) / std::max(Distance(pose.at, p), 0.1 * options.robot_radius_m);
  return {options.speed_m_per_s, std::clamp(options.speed_m_per_s * curvature, -turn, turn)};
}

/// The nearer point of an intent in the plane.
Point PlaceOf(const DriverIntent& intent, const TetherEnv& env) {
  const RobotPose& pose = env.pose();
  const double unit = kIntentAhead[1] * env.options().robot_radius_m;
  const Point ahead{std::cos(pose.heading_rad), std::sin(pose.heading_rad)}, left{-ahead.y, ahead.x};
  return pose.at + unit * (static_cast<double>(intent[0]) * ahead + static_cast<double>(intent[1]) * left);
}

/// Along the reference, which has room for the robot everywhere.
Velocity FollowReference(const TetherEnv& env, std::size_t waypoint) {
  const Polyline& waypoints = env.task().waypoints;
  const std::size_t next = waypoint + kWaypointsAhead;
  return Pursue(env.pose(), next < waypoints.size() ? waypoints[next] : env.task().goal, env.options());
}

/// What it costs to keep a velocity for a while and to follow the reference then.
double CostAhead(TetherEnv env, Velocity velocity, std::size_t waypoint, int steps) {
  const RewardOptions& reward = env.options().reward;
  double cost = 0;
  for (int k = 0; k < steps; ++k) {
    if (k >= kHeldSteps) {
      waypoint = AdvanceAlong(env, waypoint);
      velocity = FollowReference(env, waypoint);
    }
    const EnvStep step = env.StepWith(velocity.speed_m_per_s, velocity.turn_rad_per_s);
    // The sooner, the worse.
    if (step.robot_obstacle || step.held) return cost + kEndOfTheWay * (steps - k) / steps;
    cost -= (step.cable_obstacle ? reward.cable_obstacle : 0) + (step.cable_robot ? reward.cable_robot : 0);
    if (step.ends()) break;
  }
  return cost / steps;
}

}  // namespace

DriverIntent IntentOf(const RobotPose& pose, std::span<const Point> way, double robot_radius_m) {
  DriverIntent intent{};
  const double unit = kIntentAhead[1] * robot_radius_m;
  const Point ahead{std::cos(pose.heading_rad), std::sin(pose.heading_rad)};
  for (std::size_t i = 0; i < 2; ++i) {
    double left_m = kIntentAhead[i] * robot_radius_m;
    Point at = pose.at;
    for (const Point p : way) {
      const double step = Distance(at, p);
      if (step >= left_m) {
        if (step > 0) at = Lerp(at, p, left_m / step);
        break;
      }
      left_m -= step;
      at = p;
    }
    const Point off = (1 / unit) * (at - pose.at);
    intent[2 * i] = static_cast<float>(Dot(ahead, off));
    intent[2 * i + 1] = static_cast<float>(Cross(ahead, off));
  }
  return intent;
}

DriverPolicy::DriverPolicy(const Mlp& network, const Kernels& kernels, const DriverOptions& options)
    : network_(network), pass_(network.widths(), 1, kernels), options_(options) {
  TAUTLINE_CHECK(network.inputs() == kViewSize && network.outputs() == kIntentSize);
}

Expected<DriverPolicy> DriverPolicy::Read(std::string_view bytes, const std::string& name, const Kernels& kernels,
                                          const DriverOptions& options) {
  const auto model = ReadOnnx(bytes, name);
  if (!model) return tl::unexpected(model.error());
  if (model->network.inputs() != kViewSize || model->network.outputs() != kIntentSize) {
    return InvalidInput("a network of " + std::to_string(model->network.inputs()) + " inputs and " +
                            std::to_string(model->network.outputs()) +
                            " outputs is no policy for all maps, which has " + std::to_string(kViewSize) + " and " +
                            std::to_string(kIntentSize) + ": take one that `learn imitate` wrote",
                        name);
  }
  return DriverPolicy(model->network, kernels, options);
}

DriverIntent DriverPolicy::Want(const TetherEnv& env, std::size_t waypoint) {
  DriverIntent intent;
  const std::span<const float> values = pass_.Forward(network_, LookAround(env, waypoint));
  std::copy(values.begin(), values.end(), intent.begin());
  return intent;
}

Velocity DriverPolicy::Choose(const TetherEnv& env, std::size_t waypoint) {
  const TetherEnvOptions& with = env.options();
  // A network that was not taught well may want nothing that is a number.
  const Point place = PlaceOf(Want(env, waypoint), env);
  const Velocity wanted = IsFinite(place) ? Pursue(env.pose(), place, with) : FollowReference(env, waypoint);
  if (options_.look_ahead_steps <= 0) return wanted;
  const auto cost_of = [&](const Velocity& velocity) {
    return options_.caution * CostAhead(env, velocity, waypoint, options_.look_ahead_steps);
  };
  Velocity best = wanted;
  double least = cost_of(wanted);
  for (const Velocity& other : BasicVelocities(with)) {
    const double turn = std::abs(other.turn_rad_per_s - wanted.turn_rad_per_s) / with.turn_rad_per_s;
    const double off = turn + (other.speed_m_per_s == wanted.speed_m_per_s ? 0 : 1);
    if (off >= least) continue;
    const double cost = off + cost_of(other);
    if (cost < least) best = other, least = cost;
  }
  return best;
}

DrivenMotion DriverPolicy::Drive(TetherEnv env) {
  const TetherEnv start = env;
  std::vector<Velocity> velocities;
  std::size_t waypoint = 0;
  int waited = 0;
  for (EnvStep step; !step.ends() && !step.held;) {
    const std::size_t next = AdvanceAlong(env, waypoint);
    waited = next > waypoint ? 0 : waited + 1;
    waypoint = next;
    if (waited > kPatience * 3 / 2) waited = 0;
    velocities.push_back(waited > kPatience ? FollowReference(env, waypoint) : Choose(env, waypoint));
    step = env.StepWith(velocities.back().speed_m_per_s, velocities.back().turn_rad_per_s);
  }
  return DriveMotion(start, velocities);
}

}  // namespace tautline
