// The preparation of a world for the answers.
#ifndef APPS_ANSWERS_PREPARATION_H_
#define APPS_ANSWERS_PREPARATION_H_

#include <optional>
#include <string>

#include "tautline/base/error.h"
#include "tautline/planners/tether/tether_planner.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// How a world is prepared.
struct Preparation {
  std::optional<std::string> prepared = {};  ///< The bytes of a prepared map; nothing: from the start.
  std::string path = {};                     ///< Where they come from, for errors.
  Watcher watch = {};                        ///< Told how far it is.
};

/// The planner of the scene's world. Errors: as TetherPlanner::Prepare, or, with the path, as PreparedFile::Read.
[[nodiscard]] Expected<TetherPlanner> PreparePlanner(const Scene& scene, const Preparation& preparation);

}  // namespace tautline

#endif  // APPS_ANSWERS_PREPARATION_H_
