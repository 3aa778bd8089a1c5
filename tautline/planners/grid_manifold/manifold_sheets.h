// The manifold word by word: its sheets and their boundaries [Igarashi2010, Figs. 2 and 15].
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_MANIFOLD_SHEETS_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_MANIFOLD_SHEETS_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tautline/geometry/polygon.h"
#include "tautline/planners/grid_manifold/grid_manifold.h"

namespace tautline {

/// All vertices of one word.
struct ManifoldSheet {
  Word word;                               ///< Theirs.
  std::int64_t vertices = 0;               ///< How many there are.
  LatticeDistance nearest = 0;             ///< The least distance from the base among them.
  LatticeDistance farthest = 0;            ///< The largest.
  std::vector<PolygonWithHoles> boundary;  ///< Around their cells, metres; for the first sheets only.
};

/// The sheets, largest first and of equal ones the first word; the first `outlined` of them with their boundaries.
/// O(vertices log words).
std::vector<ManifoldSheet> SheetsOf(const GridManifold& manifold, std::size_t outlined);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_MANIFOLD_SHEETS_H_
