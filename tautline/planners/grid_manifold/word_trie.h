// Reduced words as nodes of a tree: the Cayley graph of the free group, as far as it is needed.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_WORD_TRIE_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_WORD_TRIE_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tautline/homotopy/word.h"

namespace tautline {

/// A letter of a trie: twice the number of the obstacle, plus 1 for the inverse. letter ^ 1 is its inverse.
using TrieLetter = std::int32_t;

/// Words by number. Appending a letter goes to a child, cancelling one goes to the parent, and words are equal exactly
/// when their numbers are.
class WordTrie {
 public:
  using WordNumber = std::uint32_t;                    ///< The number of a word.
  static constexpr WordNumber kEmpty = 0;              ///< That of the empty word.
  static constexpr WordNumber kMissing = 0xffffffffU;  ///< A word that the trie does not hold.

  /// The empty word alone.
  WordTrie();

  /// The word with one more letter, which is added where it is new. O(1) expected.
  WordNumber Append(WordNumber word, TrieLetter letter);
  /// The same where the word is known, or kMissing.
  WordNumber Find(WordNumber word, TrieLetter letter) const;

  /// The word without its last letter. Requires word != kEmpty.
  WordNumber parent(WordNumber word) const { return nodes_[word].parent; }
  /// Its last letter. Requires word != kEmpty.
  TrieLetter last(WordNumber word) const { return nodes_[word].letter; }
  /// How many words there are; they have the numbers below.
  std::size_t size() const { return nodes_.size(); }
  /// The memory it holds.
  std::size_t bytes() const;

  /// The letters of a word in order. O(letters).
  std::vector<TrieLetter> LettersOf(WordNumber word) const;
  /// The same as a Word.
  Word ToWord(WordNumber word) const;

 private:
  struct Node {
    WordNumber parent = kEmpty;
    TrieLetter letter = -1;
  };

  std::size_t Slot(WordNumber word, TrieLetter letter) const;
  void Rehash();

  std::vector<Node> nodes_;
  std::vector<WordNumber> table_;  ///< Open addressing over (parent, letter); kMissing where nothing is.
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_WORD_TRIE_H_
