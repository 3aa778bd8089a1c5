// The pictures of answers about manifolds, the same for every face.
#ifndef APPS_PICTURES_MANIFOLD_PICTURES_H_
#define APPS_PICTURES_MANIFOLD_PICTURES_H_

#include <string>

#include "apps/answers/manifold_answer.h"

namespace tautline {

/// As SVG: the deadlocks, or else the field, or else the sheets, where the answer has them; or else how many classes
/// each cell has.
std::string DrawAnswer(const Scene& scene, const ManifoldAnswer& answer);

}  // namespace tautline

#endif  // APPS_PICTURES_MANIFOLD_PICTURES_H_
