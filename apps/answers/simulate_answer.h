// The question of `fleet simulate`, answered: what every face of tautline hands out.
#ifndef APPS_ANSWERS_SIMULATE_ANSWER_H_
#define APPS_ANSWERS_SIMULATE_ANSWER_H_

#include <optional>
#include <string>
#include <vector>

#include "apps/answers/exit_status.h"
#include "apps/answers/fleet_setup.h"
#include "tautline/planners/fleet/playback.h"

namespace tautline {

struct SimulateQuestion {
  FleetMode mode = FleetMode::kStraightConcurrent;  ///< Of the plan that is made and played, where none is given.
  std::vector<std::string> order;  ///< Instead: the names of all robots, which drive straight, one after the other.
  std::optional<Json> plan;        ///< Instead: the result of `fleet plan`.
  std::string plan_file;           ///< Where that came from, for messages.
  int frames = 0;                  ///< Moments for pictures.
  Watcher watch = {};              ///< Told how far the playback has come.
};

struct SimulateAnswer {
  FleetSetup setup;
  std::vector<RobotSchedule> schedule = {};  ///< What was played, by RobotId; empty where nothing was.
  std::optional<Playback> playback = {};     ///< Nothing where nothing was, or where robots meet.
  std::vector<RobotId> too_short = {};       ///< Robots whose tethers would have to be longer.
  std::string explanation = {};              ///< Why it does not come out; empty when it does.
  Json json = {};                            ///< The result as docs/fleet_simulate.md describes it.
  ExitStatus status = kExitSolved;           ///< kExitInfeasible where the layout does not come out.
};

/// Plays a plan: one that is made for the scene's layout, the one that is given, or robots one after the other. Errors:
/// as SetUpFleetLayout; the order does not name each robot once; the plan is not one for this fleet; the watcher said
/// stop. Throws std::logic_error where the two witnesses disagree about what comes out.
[[nodiscard]] Expected<SimulateAnswer> AnswerSimulate(const Scene& scene, const SimulateQuestion& question);

}  // namespace tautline

#endif  // APPS_ANSWERS_SIMULATE_ANSWER_H_
