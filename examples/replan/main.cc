// replan SCENE X,Y SECONDS [--pace]: plans anew 50 times a second while the goal moves evenly on a line, from the goal
// of the scene to (X, Y), metres. Each line is a tick: time, goal, status, length of the motion. The world is prepared
// once; a tick costs only its query. --pace waits for the time of each tick and says how many came late; without it,
// ticks follow each other at once.
//
// Exit status: 0 all ticks were answered (where there is no motion, the tick says why), 2 bad input.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

#include "tautline/planners/tether/tether_planner.h"
#include "tautline/scene/scene_file.h"

namespace {

constexpr int kTicksPerSecond = 50;

struct Drive {
  tautline::Point from;
  tautline::Point to;
  int ticks = 0;
  bool pace = false;
};

/// One line of the answer.
void Print(int tick, tautline::Point goal, const tautline::PlanResult& result) {
  std::printf("%.2f s  goal %.3f %.3f  ", static_cast<double>(tick) / kTicksPerSecond, goal.x, goal.y);
  if (result.motion) {
    std::printf("solved %.4f m\n", result.motion->path.length);
  } else if (result.status == tautline::PlanStatus::kInfeasible) {
    std::printf("infeasible %s\n", ToString(result.obstruction).c_str());
  } else {
    std::printf("budget_exceeded\n");
  }
}

void Replan(const tautline::TetherPlanner& planner, const tautline::Tether& tether, const Drive& drive) {
  const auto start = std::chrono::steady_clock::now();
  int late = 0;
  for (int tick = 0; tick <= drive.ticks; ++tick) {
    if (drive.pace) std::this_thread::sleep_until(start + tick * std::chrono::milliseconds(1000 / kTicksPerSecond));
    const tautline::Point goal = Lerp(drive.from, drive.to, static_cast<double>(tick) / drive.ticks);
    // A budget bounds the time of a tick; a search that it stops is tried again in the next.
    Print(tick, goal, planner.Plan(tether, goal, {.budget = 100'000}));
    const auto next = start + (tick + 1) * std::chrono::milliseconds(1000 / kTicksPerSecond);
    if (drive.pace && std::chrono::steady_clock::now() > next) ++late;
  }
  if (drive.pace) std::fprintf(stderr, "%d of %d ticks were late\n", late, drive.ticks + 1);
}

int Complain(const std::string& what) {
  std::fprintf(stderr, "replan: %s\n", what.c_str());
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  tautline::Point to;
  double seconds = 0;
  const bool pace = argc == 5 && std::string(argv[4]) == "--pace";
  if ((argc != 4 && !pace) || std::sscanf(argv[2], "%lf,%lf", &to.x, &to.y) != 2 || !IsFinite(to) ||
      std::sscanf(argv[3], "%lf", &seconds) != 1 || !(seconds >= 0.02 && seconds <= 3600)) {
    return Complain("call it as `replan SCENE X,Y SECONDS [--pace]`, with 0.02 to 3600 seconds");
  }
  const auto scene = tautline::ReadSceneFile(argv[1]);
  if (!scene) return Complain(ToString(scene.error()));
  if (!scene->tether || !scene->goal) return Complain(std::string(argv[1]) + ": the scene needs a tether and a goal");
  const auto planner = tautline::TetherPlanner::Prepare(scene->world);
  if (!planner) return Complain(ToString(planner.error()));
  const int ticks = static_cast<int>(std::lround(seconds * kTicksPerSecond));
  Replan(*planner, *scene->tether, {.from = *scene->goal, .to = to, .ticks = ticks, .pace = pace});
  return 0;
}
