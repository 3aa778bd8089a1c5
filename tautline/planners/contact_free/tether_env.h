// A robot that drags a cable, as an environment for learning: states, actions, rewards.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_TETHER_ENV_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_TETHER_ENV_H_

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "tautline/base/error.h"
#include "tautline/cable/cable_chain.h"
#include "tautline/planners/contact_free/contact_map.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// What a step is worth; the defaults are those of [Shimada2024, Sec. 4.3].
struct RewardOptions {
  double goal = 50;                   ///< For reaching the goal.
  double robot_obstacle = -1;         ///< For hitting an obstacle; the episode ends.
  double cable_obstacle = -1;         ///< For a step after which the cable touches an obstacle.
  double cable_robot = -0.5;          ///< For a step after which the robot stands on its cable.
  double rotation = -0.1;             ///< For a step that turns on the spot.
  double time = -0.001;               ///< For every step.
  double progress = 50;               ///< Shared evenly among the way-points, each paid once an episode.
  double deviation = -1;              ///< For each metre by which the nearest way-point is too far away.
  double deviation_from_radii = 2.5;  ///< Too far begins here, robot radii.
  bool use_reference = true;          ///< Whether progress and deviation count. [Shimada2024, Sec. 6.3.4]
};

/// How an observation is written.
enum class ObservationScale {
  kScaled,  ///< Position and heading in [-1, 1].
  kMetres,  ///< Metres and radians, as in the paper.
};

/// The robot and its world; the defaults are those of [Shimada2024], or for want of them, those of the README.
struct TetherEnvOptions {
  double robot_radius_m = 0.5;                               ///< Positive.
  double link_length_m = 1;                                  ///< Of the cable. Positive.
  double speed_m_per_s = 1;                                  ///< Going straight.
  double turn_rad_per_s = 2;                                 ///< Turning on the spot.
  double dt_s = 0.1;                                         ///< A step.
  double goal_radius_m = 0.5;                                ///< The goal is reached within this.
  int max_steps = 500;                                       ///< After which an episode is cut.
  double grid_m = 0.2;                                       ///< To which positions are rounded in observations.
  double grid_rad = 0.17453292519943295;                     ///< To which headings are: 10 degrees.
  ObservationScale observation = ObservationScale::kScaled;  ///< How they are written.
  double start_noise_m = 0;                                  ///< The start is moved by up to this, by the seed.
  double heading_noise_rad = 0;                              ///< The heading is turned by up to this, by the seed.
  RewardOptions reward;                                      ///< What a step is worth.
};

/// Where an episode starts and what it is for.
struct TetherTask {
  Polyline laid;  ///< The cable from its base to the robot's centre; one point: the robot stands at the base.
  std::optional<double> heading_rad;  ///< Absent: along the last segment of the cable, else along the reference.
  double cable_length_m = 0;          ///< All of it.
  Point goal;                         ///< For the robot's centre.
  Polyline waypoints;                 ///< Of the reference path, without its start. May be empty.
};

/// The task of a scene with a tether and a goal, and with the robot's heading where it says one; without way-points.
/// Errors: those of RequireTetherAndGoal.
[[nodiscard]] Expected<TetherTask> TaskOf(const Scene& scene);

/// The options with the scene's radius, where it says one; the links are twice as long, as in the paper.
TetherEnvOptions OptionsFor(const Scene& scene, TetherEnvOptions options = {});

/// The pose of the robot.
struct RobotPose {
  Point at;                ///< Its centre.
  double heading_rad = 0;  ///< Counter-clockwise from the x axis, in (-pi, pi].
};

/// The three actions of [Shimada2024, Sec. 6.1].
enum class TetherAction : std::uint8_t { kRight, kStraight, kLeft };
/// How many there are.
inline constexpr int kTetherActions = 3;

/// What a step did.
struct EnvStep {
  double reward = 0;            ///< Eq. 1.
  bool cable_obstacle = false;  ///< The cable touches an obstacle. Eq. 8.
  bool cable_robot = false;     ///< The robot stands on its cable. Eq. 9.
  bool robot_obstacle = false;  ///< It hit an obstacle: the episode is over.
  bool held = false;            ///< The cable is too short for the motion: nothing moved.
  bool at_goal = false;         ///< It reached the goal: the episode is over.
  bool cut = false;             ///< The steps are used up; the episode is not over, but ends.
  /// Whether the episode ends here.
  bool ends() const { return robot_obstacle || at_goal || cut; }
};

/// Position and heading, rounded and scaled.
using Observation = std::array<float, 3>;

/// One robot on one task. Deterministic; a copy goes on independently and shares the map. [Shimada2024, Sec. 5, 6.1]
class TetherEnv {
 public:
  /// Keeps a reference to `map`. InvalidInput where a number makes no sense, the cable does not reach the robot's tail,
  /// or the robot or the goal stands in an obstacle.
  static Expected<TetherEnv> Create(const ContactMap& map, const TetherTask& task, const TetherEnvOptions& options);

  /// Starts an episode. The seed moves the start where the options say so; places in obstacles are drawn again.
  Observation Reset(std::uint64_t seed = 0);

  /// One of the three actions. Requires an episode that has not ended.
  EnvStep Step(TetherAction action);

  /// Any velocities for one step, as a tracking robot has them. Requires finite ones.
  EnvStep StepWith(double speed_m_per_s, double turn_rad_per_s);

  /// The state as the learner sees it.
  Observation Observe() const;

  /// Where the robot is.
  const RobotPose& pose() const { return pose_; }
  /// Where the cable lies, from base to tail.
  const CableChain& cable() const { return cable_; }
  /// Of this episode.
  int steps() const { return steps_; }
  /// What it was made from.
  const TetherTask& task() const { return setup_->task; }
  /// What it was made with.
  const TetherEnvOptions& options() const { return setup_->options; }
  /// What is in the way.
  const ContactMap& map() const { return *setup_->map; }

 private:
  /// What all episodes share.
  struct Setup {
    const ContactMap* map;
    TetherTask task;
    TetherEnvOptions options;
    double heading_rad;      ///< At the start, without noise.
    bool base_is_at_a_wall;  ///< Then the cable may touch blocked ground within a robot radius of it.
  };

  explicit TetherEnv(std::shared_ptr<const Setup> setup);

  void StartAt(const RobotPose& pose);
  Point Tail(const RobotPose& pose) const;
  bool Move(double speed_m_per_s, double turn_rad_per_s, EnvStep& step);
  bool CableTouchesObstacle() const;
  bool CableIsUnderRobot() const;
  double FollowReference();

  std::shared_ptr<const Setup> setup_;  ///< Shared, so that copies for trials are cheap; it never changes.
  RobotPose pose_;
  CableChain cable_;
  std::vector<std::uint8_t> passed_;  ///< By way-point.
  int steps_ = 0;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_TETHER_ENV_H_
