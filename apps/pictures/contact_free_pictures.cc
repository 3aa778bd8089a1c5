#include "apps/pictures/contact_free_pictures.h"

#include "tautline/draw/draw_contact_free.h"

namespace tautline {
namespace {

ContactFreePicture PictureOf(const ContactFreeAnswer& answer) {
  return {.motion = answer.result.motion,
          .robot_radius_m = answer.result.env.robot_radius_m,
          .dt_s = answer.result.env.dt_s,
          .explanation = answer.result.explanation};
}

}  // namespace

std::string DrawAnswer(const Scene& scene, const ContactFreeAnswer& answer) {
  return DrawContactFree(scene, PictureOf(answer));
}

std::string AnimateAnswer(const Scene& scene, const ContactFreeAnswer& answer) {
  return AnimateContactFree(scene, PictureOf(answer));
}

}  // namespace tautline
