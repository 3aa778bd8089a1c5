// Sets of vertices of a manifold.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_VERTEX_MASK_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_VERTEX_MASK_H_

#include <vector>

#include "tautline/planners/grid_manifold/grid_manifold.h"

namespace tautline {

/// A set of vertices: the cells of each page, by page. An empty list is the empty set.
using VertexMask = std::vector<TileMask>;

/// Whether a vertex is in a set. O(1).
inline bool Contains(const VertexMask& mask, ManifoldVertex v) {
  return v.page < mask.size() && (mask[v.page] >> v.cell & 1) != 0;
}

/// Adds a vertex to a set of vertices of `manifold`. O(1), the first time O(pages).
inline void Insert(const GridManifold& manifold, ManifoldVertex v, VertexMask& mask) {
  if (mask.empty()) mask.resize(manifold.pages(), 0);
  mask[v.page] |= TileMask{1} << v.cell;
}

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_VERTEX_MASK_H_
