#include "tautline/planners/grid_manifold/intermediate_targets.h"

#include <algorithm>

namespace tautline {
namespace {

/// Whether no neighbour comes before it: has a larger score, or an equal one and a lesser number.
bool IsLocalMaximum(const AccessibleRegion& region, const std::vector<LatticeDistance>& scores, std::size_t v) {
  for (int d = 0; d < kDirections; ++d) {
    const std::int32_t to = region.next(v, d);
    if (to < 0) continue;
    const auto u = static_cast<std::size_t>(to);
    if (scores[u] > scores[v] || (scores[u] == scores[v] && u < v)) return false;
  }
  return true;
}

}  // namespace

std::vector<IntermediateTarget> FindIntermediateTargets(const AccessibleRegion& region, LatticeDistance apart) {
  const std::vector<LatticeDistance> from_centre = region.DistancesFrom(region.Centre());
  std::vector<LatticeDistance> scores = region.DistancesFrom(0);
  for (std::size_t v = 0; v < scores.size(); ++v) scores[v] = std::min(scores[v], from_centre[v]);
  std::vector<std::size_t> maxima;
  for (std::size_t v = 0; v < scores.size(); ++v) {
    if (scores[v] > 0 && IsLocalMaximum(region, scores, v)) maxima.push_back(v);
  }
  std::stable_sort(maxima.begin(), maxima.end(), [&](std::size_t a, std::size_t b) { return scores[a] > scores[b]; });
  std::vector<IntermediateTarget> targets;
  std::vector<bool> near_another(region.size(), false);
  for (const std::size_t v : maxima) {
    if (near_another[v]) continue;
    targets.push_back({region.vertices()[v], scores[v]});
    const std::vector<LatticeDistance> distances = region.DistancesFrom(v, apart);
    for (std::size_t u = 0; u < distances.size(); ++u) {
      if (distances[u] <= apart) near_another[u] = true;
    }
  }
  return targets;
}

std::vector<ManifoldVertex> SampleTargets(const GridManifold& manifold, const AccessibleRegion& region, int spacing) {
  std::vector<ManifoldVertex> targets;
  for (std::size_t v = 1; v < region.size(); ++v) {
    const GridCell cell = manifold.CellOf(region.vertices()[v]);
    if (cell.column % spacing == 0 && cell.row % spacing == 0) targets.push_back(region.vertices()[v]);
  }
  return targets;
}

}  // namespace tautline
