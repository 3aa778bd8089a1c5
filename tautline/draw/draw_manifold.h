// The picture of a manifold: how many classes each cell has.
#ifndef TAUTLINE_DRAW_DRAW_MANIFOLD_H_
#define TAUTLINE_DRAW_DRAW_MANIFOLD_H_

#include <string>

#include "tautline/planners/grid_manifold/grid_manifold.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// What the picture of a manifold shows.
struct ManifoldPicture {
  const GridManifold* manifold = nullptr;  ///< Null where there is none.
  std::string explanation;                 ///< Why there is none, or not all of it; may be empty.
};

/// The picture, as SVG, of a manifold: cells the darker the more vertices they carry, with the boundary of what the
/// tether reaches. Requires a world with a free space. Deterministic. O(cells).
std::string DrawManifold(const Scene& scene, const ManifoldPicture& picture);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_MANIFOLD_H_
