// The least choice of items that meets each of some sets.
#ifndef TAUTLINE_PLANNERS_FLEET_HITTING_SET_H_
#define TAUTLINE_PLANNERS_FLEET_HITTING_SET_H_

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tautline {

/// Items, some of which must be chosen.
using ItemSet = std::vector<std::int32_t>;

/// A choice that meets each set.
struct HittingSet {
  ItemSet chosen;         ///< In order.
  bool optimal = true;    ///< Whether there is proved to be no smaller one, nor a cheaper one as small.
  std::size_t bound = 0;  ///< No choice is smaller.
};

/// The smallest set of items that meets each of `sets`, and of those the cheapest; of equal ones, one that depends on
/// the sets alone. `costs` are those of items, not negative. Branch and bound over each connected part, with disjoint
/// sets as the bound; when `nodes`, which counts down, comes to nothing, the rest is the best found so far, at least a
/// greedy one. Requires sets that are not empty.
HittingSet LeastHittingSet(const std::vector<ItemSet>& sets, const std::vector<double>& costs, std::size_t& nodes);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_HITTING_SET_H_
