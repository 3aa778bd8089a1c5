#include "apps/answers/learn_setup.h"

#include <cstdio>
#include <utility>

#include "tautline/scene/world_digest.h"

namespace tautline {
namespace {

/// Of the grid that answers what is far from obstacles.
constexpr double kContactCell = 0.125;

/// A policy that gets nowhere plays its episode to the end, and each step is kept for the answer.
constexpr int kMostSteps = 1'000'000;

}  // namespace

Expected<LearnSetup> SetUpLearning(const Scene& scene, const TetherEnvOptions& options, const Watcher& watch) {
  if (options.max_steps > kMostSteps) {
    return InvalidInput("an episode has at most " + std::to_string(kMostSteps) + " steps", "--max-steps");
  }
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

Json TaskJson(const Scene& scene) {
  char digest[17];
  std::snprintf(digest, sizeof digest, "%016llx", static_cast<unsigned long long>(WorldDigest(scene.world)));
  Json json{{"scene", digest}};
  if (scene.tether) {
    json["base"] = {scene.tether->base.x, scene.tether->base.y};
    json["cable_length"] = scene.tether->length;
    for (const Point p : scene.tether->laid.value_or(Polyline())) json["laid"].push_back({p.x, p.y});
  }
  if (scene.goal) json["goal"] = {scene.goal->x, scene.goal->y};
  if (scene.robot.heading) json["heading"] = *scene.robot.heading;
  return json;
}

}  // namespace tautline
