// Distances and directions to a goal, all over a manifold [Igarashi2010, Sec. 3.4].
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_MANIFOLD_GOAL_FIELD_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_MANIFOLD_GOAL_FIELD_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "tautline/planners/grid_manifold/grid_manifold.h"

namespace tautline {

/// The search backwards from all vertices of a goal cell: one field serves any number of starts. It refers to its
/// manifold, which must outlive it. 4 bytes a vertex.
class ManifoldGoalField {
 public:
  /// Searches the whole manifold. O(vertices).
  ManifoldGoalField(const GridManifold& manifold, GridCell goal);

  /// The goal.
  GridCell goal() const { return goal_; }
  /// How many vertices it has.
  std::size_t goals() const { return goals_; }
  /// The way to the nearest vertex of the goal along the manifold, so that the tether suffices all along; kUnreached
  /// where there is none. Requires manifold().Has(v).
  LatticeDistance distance(ManifoldVertex v) const;
  /// The direction of the next step of a shortest way to the goal: 0 east, counter-clockwise; of several the first.
  /// Nothing at the goal and where no way leads to it. The distance there is less by the length of the step.
  std::optional<int> Direction(ManifoldVertex v) const;
  /// The vertices of a shortest way from v to the goal, both included; empty when there is none.
  std::vector<ManifoldVertex> WayFrom(ManifoldVertex v) const;

 private:
  void Offer(std::uint32_t page, int cell, LatticeDistance distance);
  void Sweep(std::uint32_t page);
  void Search();

  const GridManifold& manifold_;
  GridCell goal_;
  std::size_t goals_ = 0;
  std::vector<LatticeDistance> values_;

  /// While searching.
  std::vector<LatticeDistance> keys_;
  std::vector<TileMask> changed_;
  std::vector<std::vector<std::uint32_t>> buckets_;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_MANIFOLD_GOAL_FIELD_H_
