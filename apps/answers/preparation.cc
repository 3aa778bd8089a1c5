#include "apps/answers/preparation.h"

#include "tautline/planners/tether/prepared_file.h"

namespace tautline {

Expected<TetherPlanner> PreparePlanner(const Scene& scene, const Preparation& preparation) {
  if (!preparation.prepared) return TetherPlanner::Prepare(scene.world, {.watch = preparation.watch});
  if (preparation.watch) preparation.watch("prepared map", 0);
  auto planner = PreparedFile::Read(*preparation.prepared, scene.world);
  if (!planner) planner.error().where = preparation.path;
  return planner;
}

}  // namespace tautline
