#include "tautline/planners/grid_manifold/state_key.h"

#include <cmath>

namespace tautline {
namespace {

/// FNV-1a by words, with a shift that brings high bits down.
class KeyHash {
 public:
  void Add(std::int64_t value) {
    key_ = (key_ ^ static_cast<std::uint64_t>(value)) * 0x100000001b3ULL;
    key_ ^= key_ >> 29;
  }
  std::uint64_t key() const { return key_; }

 private:
  std::uint64_t key_ = 0xcbf29ce484222325ULL;
};

}  // namespace

std::uint64_t StateKey(const DriveState& state, double coarse_m) {
  KeyHash hash;
  hash.Add(state.at.page);
  hash.Add(state.at.cell);
  std::int64_t column = 0, row = 0;
  bool first = true;
  for (const Place& node : state.cable.nodes()) {
    const auto x = static_cast<std::int64_t>(std::floor(node.point.x / coarse_m));
    const auto y = static_cast<std::int64_t>(std::floor(node.point.y / coarse_m));
    if (!first && x == column && y == row) continue;
    first = false;
    column = x;
    row = y;
    hash.Add(x);
    hash.Add(y);
  }
  return hash.key();
}

}  // namespace tautline
