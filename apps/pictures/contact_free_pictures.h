// The pictures of contact-free plans, the same for every face.
#ifndef APPS_PICTURES_CONTACT_FREE_PICTURES_H_
#define APPS_PICTURES_CONTACT_FREE_PICTURES_H_

#include <string>

#include "apps/answers/contact_free_answer.h"

namespace tautline {

/// As SVG: the motion; or the scene, where there is none.
std::string DrawAnswer(const Scene& scene, const ContactFreeAnswer& answer);

/// The motion as a film; where there is none, a picture that stands still.
std::string AnimateAnswer(const Scene& scene, const ContactFreeAnswer& answer);

}  // namespace tautline

#endif  // APPS_PICTURES_CONTACT_FREE_PICTURES_H_
