#include "apps/pictures/contact_free_pictures.h"

#include "tautline/draw/draw_contact_free.h"

namespace tautline {
namespace {

ContactFreePicture PictureOf(const ContactFreeOptions& options, const ContactFreeAnswer& answer) {
  return {.motion = answer.result.motion,
          .robot_radius_m = options.env.robot_radius_m,
          .dt_s = options.env.dt_s,
          .explanation = answer.result.explanation};
}

}  // namespace

std::string DrawAnswer(const Scene& scene, const ContactFreeOptions& options, const ContactFreeAnswer& answer) {
  return DrawContactFree(scene, PictureOf(options, answer));
}

std::string AnimateAnswer(const Scene& scene, const ContactFreeOptions& options, const ContactFreeAnswer& answer) {
  return AnimateContactFree(scene, PictureOf(options, answer));
}

}  // namespace tautline
