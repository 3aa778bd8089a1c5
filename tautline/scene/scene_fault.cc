#include "tautline/scene/scene_fault.h"

#include <utility>

namespace tautline {

Expected<void> Checked(const std::string& what, const std::optional<Fault>& fault) {
  if (!fault) return {};
  return tl::unexpected<Error>(Error{fault->code, what + fault->text, ""});
}

Expected<void> InScene(const Scene& scene, Expected<void> checked) {
  return std::move(checked).map_error([&scene](Error error) {
    error.where = scene.path;
    return error;
  });
}

}  // namespace tautline
