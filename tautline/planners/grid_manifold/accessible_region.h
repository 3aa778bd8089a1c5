// All that a robot can get to without driving over its cable, as a graph [Igarashi2010, Sec. 4.3].
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_ACCESSIBLE_REGION_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_ACCESSIBLE_REGION_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tautline/planners/grid_manifold/open_ground.h"

namespace tautline {

/// The vertices that open steps lead to from one of them, which comes first, in the order in which they are met.
class AccessibleRegion {
 public:
  /// Finds them. O(vertices of the region).
  AccessibleRegion(const OpenGround& open, ManifoldVertex start);

  /// How many there are.
  std::size_t size() const { return vertices_.size(); }
  /// By number.
  const std::vector<ManifoldVertex>& vertices() const { return vertices_; }
  /// The number of the neighbour in a direction, or -1.
  std::int32_t next(std::size_t vertex, int direction) const {
    return next_[vertex][static_cast<std::size_t>(direction)];
  }
  /// The length of the shortest way within the region from one of them to each that is no longer than `limit`, else
  /// kUnreached. O(n + m log m) for m of them.
  std::vector<LatticeDistance> DistancesFrom(std::size_t vertex, LatticeDistance limit = kUnreached) const;
  /// The one whose farthest vertex is nearest, the graph's centre; of several the first. Bounds on eccentricities from
  /// a few searches leave most vertices out [Takes2011]; O(n) searches at worst.
  std::size_t Centre() const;

 private:
  std::vector<ManifoldVertex> vertices_;
  std::vector<std::array<std::int32_t, kDirections>> next_;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_ACCESSIBLE_REGION_H_
