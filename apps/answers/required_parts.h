// What a command needs from its scene.
#ifndef APPS_ANSWERS_REQUIRED_PARTS_H_
#define APPS_ANSWERS_REQUIRED_PARTS_H_

#include <optional>

#include "tautline/base/error.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// The error that says how to add them, when the scene lacks a tether.
std::optional<Error> MissingTether(const Scene& scene);

/// The same for a tether and a goal.
std::optional<Error> MissingTetherOrGoal(const Scene& scene);

}  // namespace tautline

#endif  // APPS_ANSWERS_REQUIRED_PARTS_H_
