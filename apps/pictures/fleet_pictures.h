// The pictures of answers about fleets, the same for every face.
#ifndef APPS_PICTURES_FLEET_PICTURES_H_
#define APPS_PICTURES_FLEET_PICTURES_H_

#include <string>

#include "apps/answers/check_answer.h"
#include "apps/answers/layouts_answer.h"

namespace tautline {

/// The layout, with what is wrong with it. As SVG, as all of these.
std::string DrawAnswer(const Scene& scene, const CheckAnswer& answer);

/// The shortest layout.
std::string DrawAnswer(const Scene& scene, const LayoutsAnswer& answer);

}  // namespace tautline

#endif  // APPS_PICTURES_FLEET_PICTURES_H_
