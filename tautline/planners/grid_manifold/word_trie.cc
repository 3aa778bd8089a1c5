#include "tautline/planners/grid_manifold/word_trie.h"

#include <algorithm>

namespace tautline {
namespace {

std::uint64_t Mixed(std::uint64_t key) {
  key *= 0x9e3779b97f4a7c15ULL;
  return key ^ (key >> 29);
}

}  // namespace

WordTrie::WordTrie() : nodes_(1), table_(16, kMissing) {}

/// Where the child stands in the table, or where it would.
std::size_t WordTrie::Slot(WordNumber word, TrieLetter letter) const {
  const std::size_t mask = table_.size() - 1;
  const std::uint64_t key = (std::uint64_t{word} << 32) | static_cast<std::uint32_t>(letter);
  std::size_t slot = static_cast<std::size_t>(Mixed(key) >> 8) & mask;
  while (table_[slot] != kMissing && (nodes_[table_[slot]].parent != word || nodes_[table_[slot]].letter != letter)) {
    slot = (slot + 1) & mask;
  }
  return slot;
}

void WordTrie::Rehash() {
  table_.assign(2 * table_.size(), kMissing);
  for (WordNumber word = 1; word < nodes_.size(); ++word) table_[Slot(nodes_[word].parent, nodes_[word].letter)] = word;
}

WordTrie::WordNumber WordTrie::Append(WordNumber word, TrieLetter letter) {
  if (word != kEmpty && nodes_[word].letter == (letter ^ 1)) return nodes_[word].parent;
  const std::size_t slot = Slot(word, letter);
  if (table_[slot] != kMissing) return table_[slot];
  const auto child = static_cast<WordNumber>(nodes_.size());
  nodes_.push_back({word, letter});
  table_[slot] = child;
  if (2 * nodes_.size() > table_.size()) Rehash();
  return child;
}

WordTrie::WordNumber WordTrie::Find(WordNumber word, TrieLetter letter) const {
  if (word != kEmpty && nodes_[word].letter == (letter ^ 1)) return nodes_[word].parent;
  return table_[Slot(word, letter)];
}

std::size_t WordTrie::bytes() const {
  return nodes_.capacity() * sizeof(Node) + table_.capacity() * sizeof(WordNumber);
}

std::vector<TrieLetter> WordTrie::LettersOf(WordNumber word) const {
  std::vector<TrieLetter> letters;
  for (; word != kEmpty; word = parent(word)) letters.push_back(last(word));
  std::reverse(letters.begin(), letters.end());
  return letters;
}

Word WordTrie::ToWord(WordNumber word) const {
  Word result;
  for (const TrieLetter letter : LettersOf(word)) result.Append({ObstacleId(letter / 2), letter % 2 != 0});
  return result;
}

}  // namespace tautline
