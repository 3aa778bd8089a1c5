// Peers of the manifold: the search over (cell, word) as it is usually written, and plain Dijkstra over cells alone.
#ifndef TAUTLINE_BENCH_PEERS_WORD_STRING_MANIFOLD_H_
#define TAUTLINE_BENCH_PEERS_WORD_STRING_MANIFOLD_H_

#include <cstddef>

#include "tautline/planners/grid_manifold/grid_manifold.h"

namespace tautline {

/// How many states a search reached, and the sum of their distances in cells.
struct SearchedStates {
  std::size_t states = 0;  ///< Within the length.
  double distances = 0;    ///< Of all of them.
};

/// Dijkstra with a binary heap over states in a hash table whose keys are a cell and a word as text. The budgets of
/// `options` are not looked at. Requires less than 100 islands.
SearchedStates SearchWordStrings(const CellGround& ground, const ManifoldOptions& options);

/// Dijkstra over the cells alone, with an array of distances and a queue of buckets one step wide: what one sheet
/// takes.
SearchedStates SearchCells(const CellGround& ground, const ManifoldOptions& options);

}  // namespace tautline

#endif  // TAUTLINE_BENCH_PEERS_WORD_STRING_MANIFOLD_H_
