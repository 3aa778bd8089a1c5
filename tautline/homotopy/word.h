// Words of the free group over the obstacles: the written form of homotopy classes.
#ifndef TAUTLINE_HOMOTOPY_WORD_H_
#define TAUTLINE_HOMOTOPY_WORD_H_

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tautline/base/error.h"
#include "tautline/scene/obstacle_id.h"

namespace tautline {

/// One crossing of an obstacle's upward ray: left to right, or (inverse) right to left.
struct Letter {
  ObstacleId obstacle;
  bool inverse = false;

  friend auto operator<=>(const Letter&, const Letter&) = default;
};

/// A reduced word: no letter stands beside its inverse. Two paths between the same points are homotopic exactly when
/// their reduced words are equal.
class Word {
 public:
  Word() = default;

  /// Appends a letter, or cancels it against its inverse at the end. O(1).
  void Append(Letter letter);

  /// Appends all letters of `other`, cancelling where they meet.
  void Append(const Word& other);

  Word Inverse() const;

  std::span<const Letter> letters() const { return letters_; }
  bool empty() const { return letters_.empty(); }
  std::size_t size() const { return letters_.size(); }

  friend bool operator==(const Word&, const Word&) = default;
  // By hand: the standard library of the browser's compiler has no <=> for vectors.
  friend bool operator<(const Word& a, const Word& b) { return a.letters_ < b.letters_; }

 private:
  std::vector<Letter> letters_;
};

/// Concatenation with cancellation.
Word operator*(const Word& first, const Word& second);

/// The letters as "name" and "name^-1", in order.
std::vector<std::string> ToStrings(const Word& word, std::span<const std::string> names);

/// The letters separated by one space; "" for the empty word.
std::string ToString(const Word& word, std::span<const std::string> names);

/// Reads "a b^-1": names separated by spaces. The result is reduced. Errors: a name that is not in `names`.
[[nodiscard]] Expected<Word> ParseWord(std::string_view text, std::span<const std::string> names);

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_WORD_H_
