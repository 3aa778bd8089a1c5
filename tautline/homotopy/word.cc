#include "tautline/homotopy/word.h"

#include <algorithm>

namespace tautline {

void Word::Append(Letter letter) {
  if (!letters_.empty() && letters_.back() == Letter{letter.obstacle, !letter.inverse}) {
    letters_.pop_back();
  } else {
    letters_.push_back(letter);
  }
}

void Word::Append(const Word& other) {
  if (&other == this) return Append(Word(other));
  for (const Letter letter : other.letters()) Append(letter);
}

Word Word::Inverse() const {
  Word inverse;
  for (auto it = letters_.rbegin(); it != letters_.rend(); ++it) inverse.Append({it->obstacle, !it->inverse});
  return inverse;
}

Word operator*(const Word& first, const Word& second) {
  Word product = first;
  product.Append(second);
  return product;
}

std::vector<std::string> ToStrings(const Word& word, std::span<const std::string> names) {
  std::vector<std::string> strings;
  for (const Letter letter : word.letters()) {
    strings.push_back(names[letter.obstacle.index()] + (letter.inverse ? "^-1" : ""));
  }
  return strings;
}

std::string ToString(const Word& word, std::span<const std::string> names) {
  std::string text;
  for (const std::string& letter : ToStrings(word, names)) {
    if (!text.empty()) text += ' ';
    text += letter;
  }
  return text;
}

Expected<Word> ParseWord(std::string_view text, std::span<const std::string> names) {
  static constexpr std::string_view kInverse = "^-1";
  Word word;
  std::size_t begin = 0;
  while ((begin = text.find_first_not_of(' ', begin)) != std::string_view::npos) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    std::string_view name = text.substr(begin, end - begin);
    begin = end;
    const bool inverse = name.size() > kInverse.size() && name.substr(name.size() - kInverse.size()) == kInverse;
    if (inverse) name.remove_suffix(kInverse.size());
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      return InvalidInput("no obstacle is called '" + std::string(name) +
                          "'; a word is made of obstacle names, such as " + (names.empty() ? "a" : names[0]) + " or " +
                          (names.empty() ? "a" : names[0]) + "^-1");
    }
    word.Append({ObstacleId(static_cast<std::size_t>(found - names.begin())), inverse});
  }
  return word;
}

}  // namespace tautline
