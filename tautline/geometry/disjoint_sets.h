// Union-find over 0, 1, ..., n-1.
#ifndef TAUTLINE_GEOMETRY_DISJOINT_SETS_H_
#define TAUTLINE_GEOMETRY_DISJOINT_SETS_H_

#include <cstddef>
#include <numeric>
#include <vector>

namespace tautline {

/// Sets that only ever merge. Path halving; near-constant time per call.
class DisjointSets {
 public:
  /// `count` sets of one item each: 0, 1, ..., count - 1.
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  /// The representative of the set that holds the item: its smallest member.
  std::size_t Find(std::size_t item) {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }

  /// The smaller representative stays, so that the outcome does not depend on the order of calls.
  void Unite(std::size_t a, std::size_t b) {
    a = Find(a);
    b = Find(b);
    if (a < b) parent_[b] = a;
    if (b < a) parent_[a] = b;
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace tautline

#endif  // TAUTLINE_GEOMETRY_DISJOINT_SETS_H_
