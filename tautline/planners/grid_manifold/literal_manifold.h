// The construction of [Igarashi2010, Fig. 4] as it is printed, for comparison.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_LITERAL_MANIFOLD_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_LITERAL_MANIFOLD_H_

#include <array>
#include <cstdint>
#include <vector>

#include "tautline/planners/grid_manifold/cell_ground.h"

namespace tautline {

/// A manifold as a list of vertices with their neighbours, without words.
struct LiteralManifold {
  /// A vertex of the paper's graph.
  struct Vertex {
    GridCell cell;                                       ///< POS.
    std::int32_t distance = 0;                           ///< DIST, steps.
    std::array<std::int32_t, 4> beside{-1, -1, -1, -1};  ///< ADJACENT, in the order of insertion.
    std::uint8_t degree = 0;                             ///< How many of them there are.
  };
  std::vector<Vertex> vertices;  ///< In the order of their making, the base first.
  std::int64_t edges = 0;        ///< Each once.
  bool budget_exceeded = false;  ///< Stopped at max_vertices.

  /// How many cells carry 1, 2, 3 ... vertices. O(vertices log vertices).
  std::vector<std::int64_t> Multiplicity() const;
};

/// Builds the 4-connected manifold of a free base: wavefront expansion that joins a new vertex to a vertex beside it
/// only when both have a neighbour of the parent in common. Vertices nearer than `length_cells` are expanded, so that
/// for a length that is no whole number there is one layer more than within the length. O(vertices).
LiteralManifold BuildLiteralManifold(const CellGround& ground, GridCell base, double length_cells,
                                     std::int64_t max_vertices);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_LITERAL_MANIFOLD_H_
