// What `manifold --deadlocks` adds to its answer.
#ifndef APPS_ANSWERS_DEADLOCK_JSON_H_
#define APPS_ANSWERS_DEADLOCK_JSON_H_

#include <string>
#include <vector>

#include "apps/answers/json_values.h"
#include "tautline/planners/grid_manifold/deadlocks.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// What one obstacle has to do with deadlocks.
struct DeadlockCause {
  std::string obstacle;       ///< An island, an obstacle of the scene that is joined to walls, or "walls".
  std::size_t deadlocks = 0;  ///< How many it causes.
  std::int64_t closed = 0;    ///< Vertices that they are the first to close.
};

/// The causes, those that close most first, then by name.
std::vector<DeadlockCause> CausesOf(const World& world, const GridManifold& manifold, const DeadlockAreas& areas);

/// Adds `contacts`, `deadlocks`, `closed_vertices`, `deadlock_area`, `lost_area` and `deadlock_obstacles`, as
/// docs/manifold.md describes them.
void AddDeadlocks(const World& world, const GridManifold& manifold, const DeadlockAreas& areas, Json& json);

}  // namespace tautline

#endif  // APPS_ANSWERS_DEADLOCK_JSON_H_
