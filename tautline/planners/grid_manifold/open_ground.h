// Which steps of a manifold a robot may take that does not drive over its cable.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_OPEN_GROUND_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_OPEN_GROUND_H_

#include <optional>

#include "tautline/planners/grid_manifold/cable_clearance.h"
#include "tautline/planners/grid_manifold/vertex_mask.h"

namespace tautline {

/// A manifold less what the cable and the caller close. Refers to its parts.
class OpenGround {
 public:
  /// `closed`: vertices not to be entered.
  OpenGround(const GridManifold& manifold, const CableClearance& clearance, const VertexMask& closed)
      : manifold_(manifold), clearance_(clearance), closed_(closed) {}

  /// The manifold.
  const GridManifold& manifold() const { return manifold_; }

  /// Whether a vertex is neither near the cable nor closed.
  bool IsOpen(ManifoldVertex v) const { return clearance_.IsClear(manifold_.CellOf(v)) && !Contains(closed_, v); }

  /// Whether the step between two neighbours is open: the one it leads to is clear of the cable and not closed. A robot
  /// that stands where it should not may get away: farther from the cable, and among closed vertices nearer to the
  /// base.
  bool Allows(ManifoldVertex from, ManifoldVertex to) const {
    const GridCell cell = manifold_.CellOf(to);
    if (!clearance_.IsClear(cell) && clearance_.at(cell) <= clearance_.at(manifold_.CellOf(from))) return false;
    return !Contains(closed_, to) || (Contains(closed_, from) && manifold_.distance(to) < manifold_.distance(from));
  }

  /// The vertex that an open step leads to, or nothing.
  std::optional<ManifoldVertex> Step(ManifoldVertex from, int direction) const {
    const auto to = manifold_.Step(from, direction);
    return to && Allows(from, *to) ? to : std::nullopt;
  }

 private:
  const GridManifold& manifold_;
  const CableClearance& clearance_;
  const VertexMask& closed_;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_OPEN_GROUND_H_
