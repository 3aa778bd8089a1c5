// Reduced words as numbers: the Cayley tree of the free group over the obstacles, grown as needed.
#ifndef TAUTLINE_PLANNERS_TETHER_WORD_TREE_H_
#define TAUTLINE_PLANNERS_TETHER_WORD_TREE_H_

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "tautline/homotopy/word.h"

namespace tautline {

/// Each word is its longest proper prefix and one more letter; number 0 is the empty word.
class WordTree {
 public:
  /// The number of a word with the letters of another appended and cancelled. O(1) expected per letter.
  std::int32_t Append(std::int32_t word, const Word& tail) {
    for (const Letter letter : tail.letters()) word = Append(word, letter);
    return word;
  }

  Word ToWord(std::int32_t word) const {
    std::vector<Letter> letters;
    for (; word != 0; word = node(word).parent) letters.push_back(node(word).letter);
    Word result;
    for (auto letter = letters.rbegin(); letter != letters.rend(); ++letter) result.Append(*letter);
    return result;
  }

 private:
  struct Node {
    std::int32_t parent = -1;
    Letter letter;
  };

  const Node& node(std::int32_t word) const { return nodes_[static_cast<std::size_t>(word)]; }

  std::int32_t Append(std::int32_t word, Letter letter) {
    if (word != 0 && node(word).letter == Letter{letter.obstacle, !letter.inverse}) return node(word).parent;
    const auto obstacle = static_cast<std::uint64_t>(letter.obstacle.value());
    const std::uint64_t key = (static_cast<std::uint64_t>(word) << 32) | (2 * obstacle + (letter.inverse ? 1 : 0));
    const auto [at, is_new] = children_.try_emplace(key, static_cast<std::int32_t>(nodes_.size()));
    if (is_new) nodes_.push_back({word, letter});
    return at->second;
  }

  std::vector<Node> nodes_{{}};
  std::unordered_map<std::uint64_t, std::int32_t> children_;  ///< By word and letter.
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_WORD_TREE_H_
