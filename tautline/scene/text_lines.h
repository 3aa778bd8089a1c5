// A text line by line, for the readers of old line formats.
#ifndef TAUTLINE_SCENE_TEXT_LINES_H_
#define TAUTLINE_SCENE_TEXT_LINES_H_

#include <optional>
#include <string_view>
#include <vector>

namespace tautline {

/// Hands out the lines of a text, which must outlive it; a carriage return before the line's end is dropped.
class TextLines {
 public:
  /// Before the first line of `text`.
  explicit TextLines(std::string_view text) : rest_(text) {}

  /// The next line without its end; nothing after the last one.
  std::optional<std::string_view> Next();

  /// The number of the line handed out last, from 1; 0 before the first one.
  int number() const { return number_; }

 private:
  std::string_view rest_;
  int number_ = 0;
};

/// The words of a line between blanks and tabs.
std::vector<std::string_view> SplitWords(std::string_view line);

/// A whole number of at most nine digits; nothing when the text is anything else.
std::optional<int> ParseCount(std::string_view text);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_TEXT_LINES_H_
