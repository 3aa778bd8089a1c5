// The picture of a search for the best base.
#ifndef TAUTLINE_DRAW_DRAW_BEST_BASE_H_
#define TAUTLINE_DRAW_DRAW_BEST_BASE_H_

#include <string>
#include <vector>

#include "tautline/planners/grid_manifold/best_base.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// What the picture shows.
struct BestBasePicture {
  const CellGround* ground = nullptr;              ///< Never null.
  std::vector<BaseTrial> ranked;                   ///< Best first.
  BaseObjective objective = BaseObjective::kArea;  ///< What they are ranked by.
  std::string explanation;                         ///< Why there is no best one; may be empty.
};

/// The candidates, as SVG, as discs the darker the better, with the best one marked as the base and the next ones
/// numbered. Requires a world with a free space. Deterministic. O(candidates).
std::string DrawBestBase(const Scene& scene, const BestBasePicture& picture);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_BEST_BASE_H_
