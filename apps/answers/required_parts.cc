#include "apps/answers/required_parts.h"

namespace tautline {

std::optional<Error> MissingTether(const Scene& scene) {
  if (scene.tether) return std::nullopt;
  return Error{ErrorCode::kInvalidInput, "the scene has no tether; add `tether: {base: [x, y], length: metres}`",
               scene.path};
}

std::optional<Error> MissingTetherOrGoal(const Scene& scene) {
  if (auto missing = MissingTether(scene)) return missing;
  if (scene.goal) return std::nullopt;
  return Error{ErrorCode::kInvalidInput, "the scene has no goal; add `goal: [x, y]`", scene.path};
}

}  // namespace tautline
