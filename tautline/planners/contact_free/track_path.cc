#include "tautline/planners/contact_free/track_path.h"

#include <span>
#include <utility>

namespace tautline {
namespace {

/// One drive.
class Tracking {
 public:
  Tracking(TetherEnv env, const Polyline& path, const TrackPathOptions& options)
      : env_(std::move(env)),
        options_(options),
        pursuit_(path, {.speed_m_per_s = env_.options().speed_m_per_s,
                        .turn_rad_per_s = env_.options().turn_rad_per_s,
                        .dt_s = env_.options().dt_s}) {}

  TrackResult Run() {
    result_.trace.push_back(env_.pose());
    KeepCable();
    while (Advance()) {
    }
    result_.time_s = result_.steps * env_.options().dt_s;
    return std::move(result_);
  }

 private:
  /// One step; false when it was the last.
  bool Advance() {
    // A robot that turns does not move; one that moves does not get farther along than this in a step.
    pursuit_.MoveOn(env_.pose().at, 2 * env_.options().speed_m_per_s * env_.options().dt_s + options_.lookahead_m);
    double lookahead_m = options_.lookahead_m;
    EnvStep step = Try(pursuit_.Steer(env_.pose(), lookahead_m));
    for (int halved = 0; Refused(step) && halved < options_.halvings; ++halved) {
      lookahead_m /= 2;
      step = Try(pursuit_.Steer(env_.pose(), lookahead_m));
    }
    if (Refused(step) && options_.halvings > 0) {
      const EnvStep turned = Try(pursuit_.TurnTowards(env_.pose(), lookahead_m));
      if (moved_) step = turned;
    }
    if (step.robot_obstacle) return End(TrackEnd::kHitObstacle);
    if (step.held) return End(TrackEnd::kHeld);
    if (!moved_) return End(TrackEnd::kOffGoal);
    if (step.at_goal) return End(TrackEnd::kAtGoal);
    return step.cut ? End(TrackEnd::kCut) : true;
  }

  static bool Refused(const EnvStep& step) { return step.robot_obstacle || step.held; }

  /// Takes a step if nothing forbids it; moved_ says whether there was one.
  EnvStep Try(const Velocity& command) {
    moved_ = false;
    if (command.speed_m_per_s == 0 && command.turn_rad_per_s == 0) return {};
    TetherEnv next = env_;
    const EnvStep step = next.StepWith(command.speed_m_per_s, command.turn_rad_per_s);
    if (Refused(step)) return step;
    moved_ = true;
    result_.commands.push_back(command);
    Take(std::move(next), step);
    return step;
  }

  void Take(TetherEnv next, const EnvStep& step) {
    result_.driven_m += Distance(env_.pose().at, next.pose().at);
    env_ = std::move(next);
    ++result_.steps;
    result_.reward += step.reward;
    if (step.cable_obstacle) ++result_.cable_obstacle_steps;
    if (step.cable_robot) ++result_.cable_robot_steps;
    result_.trace.push_back(env_.pose());
    KeepCable();
  }

  void KeepCable() {
    if (options_.cable_every == 0 || result_.steps % options_.cable_every != 0) return;
    const auto nodes = env_.cable().nodes();
    result_.cables.emplace_back(nodes.begin(), nodes.end());
  }

  bool End(TrackEnd end) {
    result_.end = end;
    return false;
  }

  TetherEnv env_;
  const TrackPathOptions& options_;
  PurePursuit pursuit_;
  bool moved_ = false;
  TrackResult result_;
};

}  // namespace

const char* ToString(TrackEnd end) {
  switch (end) {
    case TrackEnd::kAtGoal:
      return "at_goal";
    case TrackEnd::kHitObstacle:
      return "hit_obstacle";
    case TrackEnd::kHeld:
      return "cable_too_short";
    case TrackEnd::kOffGoal:
      return "off_goal";
    case TrackEnd::kCut:
      return "time_up";
  }
  return "";
}

TrackResult TrackPath(TetherEnv env, const Polyline& path, const TrackPathOptions& options) {
  return Tracking(std::move(env), path, options).Run();
}

}  // namespace tautline
