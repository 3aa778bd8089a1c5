// The states (node, word) that a peer has reached, in a hash table with open addressing.
#ifndef TAUTLINE_BENCH_PEERS_STATE_TABLE_H_
#define TAUTLINE_BENCH_PEERS_STATE_TABLE_H_

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace tautline {

/// A node in a class, the least length found so far, and the state it was reached from.
struct PeerState {
  std::int32_t node = 0;
  std::int32_t word = 0;
  double length = std::numeric_limits<double>::infinity();
  std::int32_t parent = -1;
  bool settled = false;
};

/// Numbers the states in the order in which they are first asked for.
class StateTable {
 public:
  /// The number of a state; a new one has infinite length. O(1) expected.
  std::int32_t Obtain(std::int32_t node, std::int32_t word) {
    if (2 * states_.size() >= slots_.size()) Grow();
    const std::size_t slot = SlotOf(node, word);
    if (slots_[slot] < 0) {
      slots_[slot] = static_cast<std::int32_t>(states_.size());
      states_.push_back({.node = node, .word = word});
    }
    return slots_[slot];
  }

  /// The number of a state, or -1 where it was never asked for.
  std::int32_t Find(std::int32_t node, std::int32_t word) const { return slots_[SlotOf(node, word)]; }

  PeerState& operator[](std::int32_t id) { return states_[static_cast<std::size_t>(id)]; }
  const PeerState& operator[](std::int32_t id) const { return states_[static_cast<std::size_t>(id)]; }
  std::size_t size() const { return states_.size(); }

 private:
  std::size_t SlotOf(std::int32_t node, std::int32_t word) const {
    std::uint64_t hash =
        static_cast<std::uint64_t>(static_cast<std::uint32_t>(node)) << 32 | static_cast<std::uint32_t>(word);
    hash = (hash ^ (hash >> 31)) * 0x9e3779b97f4a7c15ULL;
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t slot = (hash ^ (hash >> 29)) & mask;; slot = (slot + 1) & mask) {
      if (slots_[slot] < 0) return slot;
      const PeerState& state = (*this)[slots_[slot]];
      if (state.node == node && state.word == word) return slot;
    }
  }

  void Grow() {
    slots_.assign(2 * slots_.size(), -1);
    for (std::size_t i = 0; i < states_.size(); ++i) {
      slots_[SlotOf(states_[i].node, states_[i].word)] = static_cast<std::int32_t>(i);
    }
  }

  std::vector<PeerState> states_;
  std::vector<std::int32_t> slots_ = std::vector<std::int32_t>(1024, -1);
};

}  // namespace tautline

#endif  // TAUTLINE_BENCH_PEERS_STATE_TABLE_H_
