#include "tautline/planners/contact_free/policy_run.h"

#include <algorithm>

namespace tautline {
namespace {

EnvFrame FrameOf(const TetherEnv& env, const EnvStep& step) {
  const auto nodes = env.cable().nodes();
  return {.t_s = env.steps() * env.options().dt_s,
          .pose = env.pose(),
          .cable = Polyline(nodes.begin(), nodes.end()),
          .cable_robot = step.cable_robot,
          .cable_obstacle = step.cable_obstacle};
}

}  // namespace

void EpisodeTotals::Add(const EnvStep& step, double moved_m) {
  reward += step.reward;
  success = success || step.at_goal;
  hit = hit || step.robot_obstacle;
  ++steps;
  cable_robot += step.cable_robot ? 1 : 0;
  cable_obstacle += step.cable_obstacle ? 1 : 0;
  length_m += moved_m;
}

double EpisodeTotals::PerMinute(int count, double dt_s) const { return steps == 0 ? 0 : 60 * count / (steps * dt_s); }

Polyline PolicyRun::Path() const {
  Polyline path;
  for (const EnvFrame& frame : frames) {
    if (path.empty() || path.back() != frame.pose.at) path.push_back(frame.pose.at);
  }
  return path;
}

PolicyRun RunPolicy(TetherEnv env, const Mlp& network, const Kernels& kernels, bool keep_frames) {
  MlpPass pass(network.widths(), 1, kernels);
  PolicyRun run;
  Observation observation = env.Reset();
  if (keep_frames) run.frames.push_back(FrameOf(env, {}));
  for (bool ended = false; !ended;) {
    const auto values = pass.Forward(network, observation);
    const auto action = std::max_element(values.begin(), values.end()) - values.begin();
    const Point from = env.pose().at;
    const EnvStep step = env.Step(static_cast<TetherAction>(action));
    run.totals.Add(step, Distance(from, env.pose().at));
    if (keep_frames) run.frames.push_back(FrameOf(env, step));
    observation = env.Observe();
    ended = step.ends();
  }
  return run;
}

}  // namespace tautline
