#include "apps/answers/learn_setup.h"

#include <utility>

namespace tautline {
namespace {

/// Of the grid that answers what is far from obstacles.
constexpr double kContactCell = 0.125;

}  // namespace

Expected<LearnSetup> SetUpLearning(const Scene& scene, const TetherEnvOptions& options, const Watcher& watch) {
  auto task = TaskOf(scene);
  if (!task) return tl::unexpected(task.error());
  auto space = BuildFreeSpace(scene.world);
  if (!space) return tl::unexpected(space.error());
  LearnSetup setup{.space = *std::move(space), .map = nullptr, .selection = {}, .env = nullptr};
  setup.map = std::make_unique<const ContactMap>(setup.space, kContactCell);
  const auto ground = PrepareRobotGround(scene.world, options.robot_radius_m, watch);
  if (!ground) return tl::unexpected(ground.error());
  setup.selection =
      SelectReference(*ground, {.laid = task->laid, .cable_length_m = task->cable_length_m, .goal = task->goal});
  if (!setup.selection.reference) return setup;
  task->waypoints = Waypoints(setup.selection.reference->path, options.robot_radius_m);
  auto env = TetherEnv::Create(*setup.map, *task, options);
  if (!env) return tl::unexpected(env.error());
  setup.env = std::make_unique<const TetherEnv>(*std::move(env));
  return setup;
}

}  // namespace tautline
