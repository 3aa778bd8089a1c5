// Faults of a scene's values as errors.
#ifndef TAUTLINE_SCENE_SCENE_FAULT_H_
#define TAUTLINE_SCENE_SCENE_FAULT_H_

#include <optional>
#include <string>

#include "tautline/base/error.h"
#include "tautline/scene/number_fault.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// An error that says what is wrong with `what`, if anything is.
[[nodiscard]] Expected<void> Checked(const std::string& what, const std::optional<Fault>& fault);

/// The same result; an error names the file that the scene came from.
[[nodiscard]] Expected<void> InScene(const Scene& scene, Expected<void> checked);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_SCENE_FAULT_H_
