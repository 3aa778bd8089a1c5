#include "apps/pictures/manifold_pictures.h"

#include "tautline/draw/draw_deadlocks.h"
#include "tautline/draw/draw_manifold.h"
#include "tautline/draw/draw_manifold_field.h"
#include "tautline/draw/draw_sheets.h"

namespace tautline {

std::string DrawAnswer(const Scene& scene, const ManifoldAnswer& answer) {
  if (!answer.manifold) return DrawManifold(scene, {nullptr, answer.explanation});
  const GridManifold& manifold = *answer.manifold;
  if (answer.deadlocks) return DrawDeadlocks(scene, manifold, *answer.deadlocks);
  if (answer.json.contains("field")) {
    if (const auto goal = manifold.ground().CellAt(*scene.goal)) {
      return DrawManifoldField(scene, manifold, ManifoldGoalField(manifold, *goal));
    }
  }
  if (!answer.sheets.empty()) return DrawSheets(scene, answer.sheets, manifold.ground().names());
  return DrawManifold(scene, {&manifold, answer.explanation});
}

}  // namespace tautline
