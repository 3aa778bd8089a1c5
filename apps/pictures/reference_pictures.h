// The picture of a reference path, the same for every face.
#ifndef APPS_PICTURES_REFERENCE_PICTURES_H_
#define APPS_PICTURES_REFERENCE_PICTURES_H_

#include <string>

#include "apps/answers/reference_answer.h"

namespace tautline {

/// As SVG: the classes, the reference and its tether, and the paths that were tracked.
std::string DrawAnswer(const Scene& scene, const ReferenceAnswer& answer);

}  // namespace tautline

#endif  // APPS_PICTURES_REFERENCE_PICTURES_H_
