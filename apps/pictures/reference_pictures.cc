#include "apps/pictures/reference_pictures.h"

#include "tautline/draw/draw_reference.h"

namespace tautline {

std::string DrawAnswer(const Scene& scene, const ReferenceAnswer& answer) {
  ReferencePicture picture{.selection = answer.exact};
  if (answer.yen) picture.yen = answer.yen;
  for (const TrackedPath& tracked : answer.tracked) {
    if (tracked.path && tracked.method != "reference") {
      picture.baselines.push_back({tracked.method, *tracked.path});
    }
  }
  return DrawReference(scene, answer.ground.space().free_space(), picture);
}

}  // namespace tautline
