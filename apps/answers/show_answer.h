// The question of `show`, answered: what every face of tautline hands out.
#ifndef APPS_ANSWERS_SHOW_ANSWER_H_
#define APPS_ANSWERS_SHOW_ANSWER_H_

#include <cstddef>

#include "apps/answers/json_values.h"
#include "tautline/base/error.h"
#include "tautline/scene/free_space.h"
#include "tautline/scene/scene.h"

namespace tautline {

struct ShowAnswer {
  FreeSpace space;
  Json json;  ///< The result as docs/show.md describes it.
};

/// What was understood of a scene. Errors: as BuildFreeSpace.
[[nodiscard]] Expected<ShowAnswer> AnswerShow(const Scene& scene);

/// The vertices of all its rings. O(rings).
std::size_t VertexCount(const FreeComponent& component);

/// Square metres of all components. O(components).
double FreeArea(const FreeSpace& space);

}  // namespace tautline

#endif  // APPS_ANSWERS_SHOW_ANSWER_H_
