// A peer: closed boundaries by nested loops over the classes of all sides [Wang2018, Alg. 2].
#ifndef TAUTLINE_BENCH_PEERS_BOUNDARY_LOOPS_H_
#define TAUTLINE_BENCH_PEERS_BOUNDARY_LOOPS_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tautline/planners/cable_workspace/boundary.h"

namespace tautline {

/// When the peer multiplies the words of the sides.
enum class Multiply {
  kWhole,    ///< All of them for each combination, in the innermost loop, as printed.
  kPartial,  ///< Each loop multiplies one more word to the product of the loops around it.
};

/// What the loops found.
struct LoopedBoundaries {
  std::vector<WorkspaceBoundary> boundaries;  ///< In the order of the loops.
  std::int64_t combinations = 0;              ///< How many the innermost loop looked at.
  bool gave_up = false;                       ///< The combinations reached their limit.
};

/// The classes of each side: up to what the shortest of the other sides leave of the limit, shortest first [Wang2018,
/// Alg. 1]. Requires that the anchors are connected.
std::vector<std::vector<TautPath>> ListSides(const CableGround& ground, const Anchors& anchors, double max_boundary);

/// All combinations of classes whose product is empty, that are within the limit, and that do not cross themselves; the
/// algorithm as printed does not look at the length, and says nothing of sides that cross each other.
LoopedBoundaries LoopOverSides(const CableGround& ground, const Anchors& anchors,
                               const std::vector<std::vector<TautPath>>& sides, double max_boundary, Multiply multiply,
                               std::int64_t max_combinations);

}  // namespace tautline

#endif  // TAUTLINE_BENCH_PEERS_BOUNDARY_LOOPS_H_
