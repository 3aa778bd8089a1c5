// The picture of a manifold word by word [Igarashi2010, Figs. 2 and 15].
#ifndef TAUTLINE_DRAW_DRAW_SHEETS_H_
#define TAUTLINE_DRAW_DRAW_SHEETS_H_

#include <string>
#include <vector>

#include "tautline/planners/grid_manifold/manifold_sheets.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// Sheets that a picture shows.
inline constexpr std::size_t kMostSheetsShown = 12;

/// The picture, as SVG: all sheets overlapped on one map, each a translucent layer with its boundary, and unfolded,
/// each on a small map of its own; the largest dozen. Requires a world with a free space, and sheets with boundaries,
/// the largest first. `names`: of the islands. Deterministic.
std::string DrawSheets(const Scene& scene, const std::vector<ManifoldSheet>& sheets,
                       const std::vector<std::string>& names);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_SHEETS_H_
