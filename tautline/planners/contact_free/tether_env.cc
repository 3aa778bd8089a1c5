#include "tautline/planners/contact_free/tether_env.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string>

#include "tautline/base/check.h"
#include "tautline/base/rng.h"
#include "tautline/homotopy/taut_path.h"
#include "tautline/scene/check_tether.h"

namespace tautline {
namespace {

constexpr double kPi = std::numbers::pi;

/// So often a start is drawn that may lie in an obstacle; then it is left where it is.
constexpr int kStartTrials = 100;

/// Finer observations would be no numbers far out, and noise beyond the largest coordinate is none of a start.
constexpr double kLeastGrid = 1e-9, kMostNoise = 1e15;

/// The same angle in (-pi, pi]. Requires a finite one.
double Wrap(double rad) {
  // Whole turns one by one only where they are few.
  if (std::abs(rad) > 6 * kPi) rad = std::remainder(rad, 2 * kPi);
  while (rad > kPi) rad -= 2 * kPi;
  while (rad <= -kPi) rad += 2 * kPi;
  return rad;
}

Point Direction(double heading_rad) { return {std::cos(heading_rad), std::sin(heading_rad)}; }

/// The direction of the last segment that has one, else towards the first other way-point or the goal, else east.
double HeadingOf(const TetherTask& task) {
  if (task.heading_rad) return Wrap(std::remainder(*task.heading_rad, 2 * kPi));
  const Point robot = task.laid.back();
  const auto angle = [](Point way) { return std::atan2(way.y, way.x); };
  for (std::size_t i = task.laid.size() - 1; i-- > 0;) {
    if (task.laid[i] != robot) return angle(robot - task.laid[i]);
  }
  for (const Point p : task.waypoints) {
    if (p != robot) return angle(p - robot);
  }
  return task.goal == robot ? 0 : angle(task.goal - robot);
}

Point TailAt(const RobotPose& pose, double radius_m) { return pose.at - radius_m * Direction(pose.heading_rad); }

/// The laid cable as far as the tail: without its last `radius`, or straight from the base where it is no longer.
Polyline LaidToTail(const Polyline& laid, Point tail, double radius_m) {
  Polyline kept = laid;
  while (kept.size() > 1 && Distance(kept.back(), laid.back()) <= radius_m) kept.pop_back();
  kept.push_back(tail);
  return kept;
}

Expected<void> CheckNumbers(const TetherEnvOptions& options) {
  const auto positive = [](double value) { return std::isfinite(value) && value > 0; };
  const auto not_negative = [](double value) { return std::isfinite(value) && value >= 0; };
  if (!positive(options.robot_radius_m)) return InvalidInput("the robot's radius must be positive and finite");
  if (!positive(options.link_length_m)) return InvalidInput("the length of a link must be positive and finite");
  if (!positive(options.dt_s)) return InvalidInput("the time of a step must be positive and finite");
  if (!positive(options.goal_radius_m)) return InvalidInput("the radius of the goal must be positive and finite");
  if (!positive(options.grid_m) || !positive(options.grid_rad) ||
      std::min(options.grid_m, options.grid_rad) < kLeastGrid) {
    return InvalidInput("the grid of observations must be at least 1e-9 and finite");
  }
  if (!not_negative(options.speed_m_per_s) || !not_negative(options.turn_rad_per_s)) {
    return InvalidInput("speeds must be finite and not negative");
  }
  if (options.turn_rad_per_s * options.dt_s > kPi) return InvalidInput("a step turns by half a turn at most");
  if (!not_negative(options.start_noise_m) || !not_negative(options.heading_noise_rad) ||
      std::max(options.start_noise_m, options.heading_noise_rad) > kMostNoise) {
    return InvalidInput("the noise of the start must be 0 or larger, and at most 1e15");
  }
  const RewardOptions& reward = options.reward;
  for (const double number :
       {reward.goal, reward.robot_obstacle, reward.cable_obstacle, reward.cable_robot, reward.rotation, reward.time,
        reward.progress, reward.deviation, reward.deviation_from_radii}) {
    if (!std::isfinite(number)) return InvalidInput("rewards and their threshold must be finite");
  }
  if (options.max_steps < 1) return InvalidInput("an episode needs at least one step");
  return {};
}

Expected<void> CheckTask(const ContactMap& map, const TetherTask& task, const TetherEnvOptions& options) {
  TAUTLINE_CHECK(!task.laid.empty());
  const bool finite = std::all_of(task.laid.begin(), task.laid.end(), IsFinite) && IsFinite(task.goal) &&
                      std::all_of(task.waypoints.begin(), task.waypoints.end(), IsFinite);
  if (!finite || (task.heading_rad && !std::isfinite(*task.heading_rad))) {
    return InvalidInput("coordinates and heading must be finite");
  }
  // The cable ends at the tail, while what is laid ends at the robot's centre: the difference is a radius less where it
  // looks away from its cable, as behind a motion that took all cable, and one more where it looks back along it.
  const Point tail = TailAt({task.laid.back(), HeadingOf(task)}, options.robot_radius_m);
  const double least = Length(LaidToTail(task.laid, tail, options.robot_radius_m));
  if (!std::isfinite(task.cable_length_m) || task.cable_length_m * (1 + kLengthTolerance) < least) {
    return InvalidInput("the cable must reach from the base to the robot's tail: make it at least " +
                        std::to_string(least) + " m long");
  }
  if (task.cable_length_m / options.link_length_m > 1e6) {
    return InvalidInput("the cable has more than a million links: make them longer");
  }
  if (map.DiscTouches(task.laid.back(), options.robot_radius_m)) {
    return InvalidInput("the robot's disc touches an obstacle where it starts: move it, or make its radius smaller");
  }
  if (map.IsBlocked(task.goal)) return InvalidInput("the goal is inside an obstacle or a wall");
  return {};
}

}  // namespace

Expected<TetherTask> TaskOf(const Scene& scene) {
  if (auto given = RequireTetherAndGoal(scene); !given) return tl::unexpected(given.error());
  const Tether& tether = *scene.tether;
  return TetherTask{.laid = tether.laid.value_or(Polyline{tether.base}),
                    .heading_rad = scene.robot.heading,
                    .cable_length_m = tether.length,
                    .goal = *scene.goal};
}

TetherEnvOptions OptionsFor(const Scene& scene, TetherEnvOptions options) {
  if (!scene.robot.radius) return options;
  options.robot_radius_m = *scene.robot.radius;
  options.link_length_m = 2 * options.robot_radius_m;
  return options;
}

Expected<TetherEnv> TetherEnv::Create(const ContactMap& map, const TetherTask& task, const TetherEnvOptions& options) {
  if (const auto checked = CheckNumbers(options); !checked) return tl::unexpected(checked.error());
  if (const auto checked = CheckTask(map, task, options); !checked) return tl::unexpected(checked.error());
  const bool at_wall = map.IsBlocked(task.laid.front());
  return TetherEnv(std::make_shared<const Setup>(Setup{&map, task, options, HeadingOf(task), at_wall}));
}

TetherEnv::TetherEnv(std::shared_ptr<const Setup> setup)
    : setup_(std::move(setup)), cable_(std::vector<Point>{setup_->task.laid.front()}, {.length_m = 1}) {
  Reset();
}

Observation TetherEnv::Reset(std::uint64_t seed) {
  const TetherEnvOptions& with = options();
  const RobotPose start{task().laid.back(), setup_->heading_rad};
  StartAt(start);
  Rng rng(seed);
  if (with.heading_noise_rad > 0) {
    pose_.heading_rad = Wrap(start.heading_rad + rng.Uniform(-with.heading_noise_rad, with.heading_noise_rad));
    // The cable that belongs to the noise is the one that the robot would have dragged there.
    if (!cable_.Pull(Tail(pose_))) StartAt(start);
  }
  for (int trial = 0; with.start_noise_m > 0 && trial < kStartTrials; ++trial) {
    const Point by{rng.Uniform(-1, 1), rng.Uniform(-1, 1)};
    const RobotPose moved{start.at + with.start_noise_m * by, pose_.heading_rad};
    if (Norm(by) > 1 || map().DiscTouches(moved.at, with.robot_radius_m) || !cable_.Pull(Tail(moved))) continue;
    pose_ = moved;
    break;
  }
  return Observe();
}

void TetherEnv::StartAt(const RobotPose& pose) {
  const TetherEnvOptions& with = options();
  pose_ = pose;
  steps_ = 0;
  passed_.assign(task().waypoints.size(), 0);
  cable_ = CableChain(LaidToTail(task().laid, Tail(pose), with.robot_radius_m),
                      {.length_m = task().cable_length_m, .link_length_m = with.link_length_m});
}

Point TetherEnv::Tail(const RobotPose& pose) const { return TailAt(pose, options().robot_radius_m); }

EnvStep TetherEnv::Step(TetherAction action) {
  const TetherEnvOptions& with = options();
  if (action == TetherAction::kStraight) return StepWith(with.speed_m_per_s, 0);
  return StepWith(0, action == TetherAction::kLeft ? with.turn_rad_per_s : -with.turn_rad_per_s);
}

EnvStep TetherEnv::StepWith(double speed_m_per_s, double turn_rad_per_s) {
  const RewardOptions& worth = options().reward;
  EnvStep step;
  ++steps_;
  step.cut = steps_ >= options().max_steps;
  step.reward = worth.time;
  if (speed_m_per_s == 0 && turn_rad_per_s != 0) step.reward += worth.rotation;
  if (!Move(speed_m_per_s, turn_rad_per_s, step)) {
    if (step.robot_obstacle) step.reward += worth.robot_obstacle;
  }
  step.cable_obstacle = CableTouchesObstacle();
  step.cable_robot = CableIsUnderRobot();
  step.at_goal = !step.robot_obstacle && Distance(pose_.at, task().goal) <= options().goal_radius_m;
  if (step.cable_obstacle) step.reward += worth.cable_obstacle;
  if (step.cable_robot) step.reward += worth.cable_robot;
  if (step.at_goal) step.reward += worth.goal;
  if (worth.use_reference) step.reward += FollowReference();
  return step;
}

// Eq. 5, with what may forbid it.
bool TetherEnv::Move(double speed_m_per_s, double turn_rad_per_s, EnvStep& step) {
  const double dt = options().dt_s;
  RobotPose moved = pose_;
  if (speed_m_per_s != 0) moved.at = pose_.at + speed_m_per_s * dt * Direction(pose_.heading_rad);
  moved.heading_rad = Wrap(pose_.heading_rad + turn_rad_per_s * dt);
  step.robot_obstacle = map().DiscTouches(moved.at, options().robot_radius_m);
  if (step.robot_obstacle) return false;
  step.held = !cable_.Pull(Tail(moved));
  if (step.held) return false;
  pose_ = moved;
  return true;
}

bool TetherEnv::CableTouchesObstacle() const {
  const std::span<const Point> nodes = cable_.nodes();
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    Point from = nodes[i];
    if (i == 0 && setup_->base_is_at_a_wall) {
      const double length = Distance(nodes[0], nodes[1]);
      if (length <= options().robot_radius_m) continue;
      from = Lerp(nodes[0], nodes[1], options().robot_radius_m / length);
    }
    if (map().SegmentTouches(from, nodes[i + 1])) return true;
  }
  return false;
}

bool TetherEnv::CableIsUnderRobot() const {
  const std::span<const Point> nodes = cable_.nodes();
  const double radius = options().robot_radius_m, link = options().link_length_m;
  double along_m = 0;
  for (std::size_t i = nodes.size() - 1; i-- > 0;) {
    along_m += i > 0 ? link : cable_.paid_out_m() - along_m;
    // On the base, the only link is as long as the radius, up to rounding.
    if (along_m <= radius * (1 + 1e-9)) continue;
    const Point off = nodes[i] - pose_.at;
    if (Dot(off, off) <= radius * radius) return true;
  }
  return false;
}

// Eqs. 3 and 4.
double TetherEnv::FollowReference() {
  const Polyline& waypoints = task().waypoints;
  if (waypoints.empty()) return 0;
  const RewardOptions& worth = options().reward;
  const double radius = options().robot_radius_m;
  double reward = 0, nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    const Point off = waypoints[i] - pose_.at;
    const double squared = Dot(off, off);
    nearest = std::min(nearest, squared);
    if (squared > radius * radius || passed_[i] != 0) continue;
    passed_[i] = 1;
    reward += worth.progress / static_cast<double>(waypoints.size());
  }
  const double too_far = std::sqrt(nearest) - worth.deviation_from_radii * radius;
  return too_far > 0 ? reward + worth.deviation * too_far : reward;
}

Observation TetherEnv::Observe() const {
  const TetherEnvOptions& with = options();
  const double x = with.grid_m * std::round(pose_.at.x / with.grid_m);
  const double y = with.grid_m * std::round(pose_.at.y / with.grid_m);
  const double heading = with.grid_rad * std::round(pose_.heading_rad / with.grid_rad);
  if (with.observation == ObservationScale::kMetres) {
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(heading)};
  }
  const Box& box = map().box();
  const Point half = 0.5 * box.size(), centre = box.centre();
  return {static_cast<float>((x - centre.x) / half.x), static_cast<float>((y - centre.y) / half.y),
          static_cast<float>(heading / kPi)};
}

}  // namespace tautline
