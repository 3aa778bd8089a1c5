// What learning starts from: a scene as an environment, with the reference path that the exact engine finds.
#ifndef APPS_ANSWERS_LEARN_SETUP_H_
#define APPS_ANSWERS_LEARN_SETUP_H_

#include <memory>
#include <string>

#include "apps/answers/json_values.h"
#include "tautline/base/error.h"
#include "tautline/planners/contact_free/select_reference.h"
#include "tautline/planners/contact_free/tether_env.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// A scene, ready to learn in.
struct LearnSetup {
  FreeSpace space;                        ///< Not grown: what the cable may touch.
  std::unique_ptr<const ContactMap> map;  ///< What robot and cable touch.
  ReferenceSelection selection;           ///< The reference path, or why there is none.
  std::unique_ptr<const TetherEnv> env;   ///< At its start; null where there is no reference.
};

/// Prepares the world, finds the reference path and cuts it into way-points at most one robot radius apart. Errors: the
/// scene has no tether or no goal, the numbers make no sense, or the robot starts in an obstacle; those of
/// BuildFreeSpace and PrepareRobotGround.
[[nodiscard]] Expected<LearnSetup> SetUpLearning(const Scene& scene, const TetherEnvOptions& options,
                                                 const Watcher& watch = {});

/// What tells one scene from another for a learner or a search: the world's digest, tether, goal and heading.
Json TaskJson(const Scene& scene);

}  // namespace tautline

#endif  // APPS_ANSWERS_LEARN_SETUP_H_
