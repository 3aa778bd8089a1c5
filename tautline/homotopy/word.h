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
  ObstacleId obstacle;   ///< Whose ray is crossed.
  bool inverse = false;  ///< From right to left.

  /// By obstacle, then forwards before inverse.
  friend auto operator<=>(const Letter&, const Letter&) = default;
};

/// A reduced word: no letter stands beside its inverse. Two paths between the same points are homotopic exactly when
/// their reduced words are equal.
class Word {
 public:
  /// The empty word: that of a path that crosses no ray.
  Word() = default;

  /// Appends a letter, or cancels it against its inverse at the end. O(1).
  void Append(Letter letter);

  /// Appends all letters of `other`, cancelling where they meet.
  void Append(const Word& other);

  /// The word of the path walked backwards: w * w.Inverse() is empty. O(letters).
  Word Inverse() const;

  /// The letters in the order of the path.
  std::span<const Letter> letters() const { return letters_; }
  /// Whether there is no letter.
  bool empty() const { return letters_.empty(); }
  /// How many letters there are.
  std::size_t size() const { return letters_.size(); }

  /// Letter by letter.
  friend bool operator==(const Word&, const Word&) = default;
  /// Letter by letter, as words of a dictionary. By hand: the standard library of the browser's compiler has no <=> for
  /// vectors.
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
