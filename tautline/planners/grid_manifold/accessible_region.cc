#include "tautline/planners/grid_manifold/accessible_region.h"

#include <algorithm>
#include <queue>
#include <unordered_map>
#include <utility>

namespace tautline {

AccessibleRegion::AccessibleRegion(const OpenGround& open, ManifoldVertex start) {
  std::unordered_map<std::uint64_t, std::int32_t> numbers;
  const auto number_of = [&](ManifoldVertex v) {
    const auto [found, added] = numbers.try_emplace(std::uint64_t{v.page} << 6 | static_cast<std::uint64_t>(v.cell),
                                                    static_cast<std::int32_t>(vertices_.size()));
    if (added) vertices_.push_back(v);
    return found->second;
  };
  number_of(start);
  const int step = open.manifold().atlas().connectivity() == Connectivity::kEight ? 1 : 2;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    next_.emplace_back().fill(-1);
    for (int d = 0; d < kDirections; d += step) {
      if (const auto to = open.Step(vertices_[i], d)) next_[i][static_cast<std::size_t>(d)] = number_of(*to);
    }
  }
  // Steps that only lead away from the cable are taken back as well: the region is a graph, not a way.
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    for (int d = 0; d < kDirections; d += step) {
      if (const std::int32_t to = next(i, d); to >= 0) {
        next_[static_cast<std::size_t>(to)][static_cast<std::size_t>(d ^ 4)] = static_cast<std::int32_t>(i);
      }
    }
  }
}

std::vector<LatticeDistance> AccessibleRegion::DistancesFrom(std::size_t vertex, LatticeDistance limit) const {
  std::vector<LatticeDistance> distances(size(), kUnreached);
  using Entry = std::pair<LatticeDistance, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  distances[vertex] = 0;
  queue.push({0, vertex});
  while (!queue.empty()) {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (distance > distances[v]) continue;
    for (int d = 0; d < kDirections; ++d) {
      const std::int32_t to = next(v, d);
      const LatticeDistance there = distance + StepLength(d);
      if (to < 0 || there > limit || there >= distances[static_cast<std::size_t>(to)]) continue;
      distances[static_cast<std::size_t>(to)] = there;
      queue.push({there, static_cast<std::size_t>(to)});
    }
  }
  return distances;
}

std::size_t AccessibleRegion::Centre() const {
  std::vector<LatticeDistance> least(size(), 0);  // No vertex has a lesser eccentricity.
  std::vector<bool> known(size(), false);
  std::size_t best = 0;
  LatticeDistance best_eccentricity = kUnreached;
  for (std::size_t v = 0;;) {
    const std::vector<LatticeDistance> distances = DistancesFrom(v);
    const LatticeDistance eccentricity = *std::max_element(distances.begin(), distances.end());
    known[v] = true;
    if (std::pair(eccentricity, v) < std::pair(best_eccentricity, best)) {
      best = v;
      best_eccentricity = eccentricity;
    }
    std::size_t following = size();
    for (std::size_t u = 0; u < size(); ++u) {
      least[u] = std::max({least[u], distances[u], eccentricity - distances[u]});
      if (known[u] || least[u] > best_eccentricity || (least[u] == best_eccentricity && u > best)) continue;
      if (following == size() || least[u] < least[following]) following = u;
    }
    if (following == size()) return best;
    v = following;
  }
}

}  // namespace tautline
