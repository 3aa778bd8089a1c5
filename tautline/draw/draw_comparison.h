// Paths of several methods on many maps, side by side [Shimada2024, Fig. 6].
#ifndef TAUTLINE_DRAW_DRAW_COMPARISON_H_
#define TAUTLINE_DRAW_DRAW_COMPARISON_H_

#include <string>
#include <vector>

#include "tautline/scene/free_space.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// A path of a method.
struct MethodPath {
  std::string method;  ///< "learned", "dijkstra", "voronoi", "search" or "general".
  Polyline path;       ///< Metres; not drawn when it is empty.
};

/// One map with its paths.
struct ComparisonPanel {
  std::string title;              ///< Above the map.
  const Scene* scene = nullptr;   ///< Must outlive the drawing, with a tether and a goal.
  FreeSpace space;                ///< Of its world.
  std::vector<MethodPath> paths;  ///< Drawn in this order.
};

/// The page, as SVG: a panel for each map, the laid cable dashed, one colour for each method. Requires a panel.
/// Deterministic.
std::string DrawComparison(const std::string& title, const std::vector<ComparisonPanel>& panels);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_COMPARISON_H_
