// Reduced words as numbers, for the peers: the Cayley tree of the free group, grown as it is walked.
#ifndef TAUTLINE_BENCH_PEERS_WORD_TRIE_H_
#define TAUTLINE_BENCH_PEERS_WORD_TRIE_H_

#include <cstdint>
#include <vector>

#include "tautline/homotopy/word.h"

namespace tautline {

/// A letter as a number: obstacle k is k + 1, its inverse -(k + 1).
inline std::int32_t LetterNumber(Letter letter) {
  const auto number = static_cast<std::int32_t>(letter.obstacle.index()) + 1;
  return letter.inverse ? -number : number;
}

/// A word is its longest proper prefix and one more letter; 0 is the empty word. Equal words have equal numbers.
class WordTrie {
 public:
  /// The word with a letter appended, or with its last letter cancelled. O(children of the word), which are few.
  std::int32_t Append(std::int32_t word, std::int32_t letter) {
    if (At(word).letter == -letter) return At(word).parent;
    for (std::int32_t child = At(word).first_child; child >= 0; child = At(child).next_sibling) {
      if (At(child).letter == letter) return child;
    }
    const auto child = static_cast<std::int32_t>(entries_.size());
    entries_.push_back({word, letter, -1, At(word).first_child});
    At(word).first_child = child;
    return child;
  }

  std::int32_t Append(std::int32_t word, const Word& suffix) {
    for (const Letter letter : suffix.letters()) word = Append(word, LetterNumber(letter));
    return word;
  }

 private:
  struct Entry {
    std::int32_t parent;
    std::int32_t letter;
    std::int32_t first_child;
    std::int32_t next_sibling;
  };

  Entry& At(std::int32_t word) { return entries_[static_cast<std::size_t>(word)]; }

  std::vector<Entry> entries_{{-1, 0, -1, -1}};
};

}  // namespace tautline

#endif  // TAUTLINE_BENCH_PEERS_WORD_TRIE_H_
