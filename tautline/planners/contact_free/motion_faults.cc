#include "tautline/planners/contact_free/motion_faults.h"

#include <cmath>

namespace tautline {
namespace {

/// Rewards are added up in another order here than there.
constexpr double kTolerance = 1e-9;

bool Near(double a, double b) { return std::abs(a - b) <= kTolerance * (1 + std::abs(b)); }

/// What driving again comes to.
struct Replay {
  int steps = 0, cable_obstacle = 0, cable_robot = 0;
  double reward = 0;
  double length_m = 0;
  bool stuck = false;  ///< A step hit something, moved nothing or came after the end.
  bool at_goal = false;
};

Replay DriveAgain(TetherEnv env, const std::vector<Velocity>& velocities) {
  Replay replay;
  EnvStep step;
  for (const Velocity& velocity : velocities) {
    if (step.ends()) replay.stuck = true;
    if (replay.stuck) break;
    step = env.StepWith(velocity.speed_m_per_s, velocity.turn_rad_per_s);
    ++replay.steps;
    replay.reward += step.reward;
    replay.length_m += std::abs(velocity.speed_m_per_s) * env.options().dt_s;
    replay.cable_obstacle += step.cable_obstacle ? 1 : 0;
    replay.cable_robot += step.cable_robot ? 1 : 0;
    replay.stuck = step.robot_obstacle || step.held;
  }
  replay.at_goal = step.at_goal;
  return replay;
}

}  // namespace

std::vector<std::string> MotionFaults(const Scene& scene, const ContactFreeResult& result, const SearchCosts& costs) {
  if (result.status != ContactFreeStatus::kSolved) return {};
  const auto space = BuildFreeSpace(scene.world);
  auto task = TaskOf(scene);
  if (!space || !task || result.motion.poses.empty()) return {"the motion cannot be driven again"};
  // Answers do not depend on the cells of the map, and the planner takes others.
  constexpr double kCell = 0.3;
  const ContactMap map(*space, kCell);
  task->heading_rad = result.motion.poses.front().heading_rad;
  const auto env = TetherEnv::Create(map, *task, result.env);
  if (!env) return {"the motion cannot be driven again: " + env.error().message};
  const Replay replay = DriveAgain(*env, result.motion.velocities);
  const MotionCosts& claimed = result.motion.costs;
  std::vector<std::string> faults;
  const auto expect = [&faults](bool holds, const char* fault) {
    if (!holds) faults.emplace_back(fault);
  };
  expect(!replay.stuck, "the motion hits something, or is held by the cable");
  expect(replay.at_goal, "the motion does not end at the goal");
  expect(replay.steps == claimed.steps, "the motion has another number of steps");
  expect(replay.cable_obstacle == claimed.cable_obstacle_steps, "cable and obstacles touch in another number of steps");
  expect(replay.cable_robot == claimed.cable_robot_steps, "the robot stands on the cable in another number of steps");
  expect(Near(-replay.reward, claimed.penalty), "the penalty is another");
  expect(Near(replay.length_m, claimed.length_m), "the length is another");
  expect(Near(result.cost, claimed.penalty + costs.per_metre * claimed.length_m), "the cost is another");
  expect(result.cost >= result.bound - kTolerance * (1 + result.bound), "the cost is below the bound");
  expect(claimed.length_m >= result.shortest_m - kTolerance, "the motion is shorter than the shortest");
  return faults;
}

}  // namespace tautline
