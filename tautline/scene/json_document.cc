#include "tautline/scene/json_document.h"

#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

namespace tautline {
namespace {

/// Follows the parser through the text and knows where the latest token starts. The lexer reads one character past a
/// number, so a line ends only when the character after its newline is read.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : text_(text) {}

  bool at_end() const { return next_ == text_.size(); }
  char current() const { return text_[next_]; }
  Position token() const { return token_; }
  Position here() const { return here_; }

  void Advance() {
    const char c = text_[next_++];
    if (after_newline_) here_ = {here_.line + 1, 0};
    ++here_.column;
    after_newline_ = c == '\n';
    if (in_string_) {
      AdvanceInString(c);
    } else {
      AdvanceOutside(c);
    }
  }

 private:
  void AdvanceInString(char c) {
    in_string_ = escaped_ || c != '"';
    escaped_ = !escaped_ && c == '\\';
  }

  void AdvanceOutside(char c) {
    constexpr std::string_view kBetween = " \t\r\n,:]}";
    const bool between = kBetween.find(c) != std::string_view::npos;
    const bool alone = c == '"' || c == '[' || c == '{';
    if (alone || (!between && !in_word_)) token_ = here_;
    in_word_ = !between && !alone;
    in_string_ = c == '"';
  }

  std::string_view text_;
  std::size_t next_ = 0;
  Position here_{1, 0};
  Position token_;
  bool after_newline_ = false;
  bool in_string_ = false;
  bool escaped_ = false;
  bool in_word_ = false;
};

/// The input iterator that the parser pulls characters from. The parser copies it, hence the pointer.
class CursorIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = char;

  CursorIterator() = default;
  explicit CursorIterator(Cursor* cursor) : cursor_(cursor) {}

  char operator*() const { return cursor_->current(); }
  CursorIterator& operator++() {
    cursor_->Advance();
    return *this;
  }
  CursorIterator operator++(int) {
    CursorIterator before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(const CursorIterator& a, const CursorIterator& b) { return a.at_end() == b.at_end(); }
  friend bool operator!=(const CursorIterator& a, const CursorIterator& b) { return !(a == b); }

 private:
  bool at_end() const { return cursor_ == nullptr || cursor_->at_end(); }

  Cursor* cursor_ = nullptr;
};

/// "... syntax error while parsing value - unexpected ']'" without the library's own prefix.
std::string Reason(const std::string& what) {
  const std::size_t syntax = what.find("syntax error");
  const std::string reason = syntax == std::string::npos ? what : what.substr(syntax);
  constexpr std::size_t kLongest = 200;
  return reason.substr(0, kLongest);
}

/// The names are those of nlohmann's SAX interface.
class Handler {
 public:
  using number_integer_t = nlohmann::json::number_integer_t;
  using number_unsigned_t = nlohmann::json::number_unsigned_t;
  using number_float_t = nlohmann::json::number_float_t;
  using string_t = nlohmann::json::string_t;
  using binary_t = nlohmann::json::binary_t;

  Handler(const Cursor& cursor, DocumentBuilder& builder) : cursor_(cursor), builder_(builder) {}

  bool null() { return builder_.Null(cursor_.token()); }
  bool boolean(bool value) { return builder_.Bool(value, cursor_.token()); }
  bool number_integer(number_integer_t value) { return Number(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) { return Number(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t&) { return Number(value); }
  bool string(string_t& value) { return builder_.String(std::move(value), cursor_.token()); }
  bool binary(binary_t&) { return builder_.Fail("binary values are not read", cursor_.token()); }
  bool start_object(std::size_t) { return builder_.StartMap(cursor_.token()); }
  bool key(string_t& name) { return builder_.Key(std::move(name), cursor_.token()); }
  bool end_object() { return builder_.End(); }
  bool start_array(std::size_t) { return builder_.StartList(cursor_.token()); }
  bool end_array() { return builder_.End(); }

  bool parse_error(std::size_t, const std::string& token, const nlohmann::detail::exception& error) {
    constexpr int kNumberOverflow = 406;
    if (error.id == kNumberOverflow) {
      return builder_.Fail("the number " + Quoted(token) + " is too large: write one below 1e308", cursor_.token());
    }
    return builder_.Fail("not valid JSON: " + Reason(error.what()), cursor_.here());
  }

 private:
  bool Number(double value) { return builder_.Number(value, cursor_.token()); }

  const Cursor& cursor_;
  DocumentBuilder& builder_;
};

}  // namespace

Expected<Document> ParseJson(std::string_view text, const std::string& file) {
  DocumentBuilder builder(file);
  if (text.size() > kMaxDocumentBytes) {
    builder.Fail("larger than 64 MiB: split the file or simplify it", {}, ErrorCode::kLimitExceeded);
    return builder.Finish();
  }
  Cursor cursor(text);
  Handler handler(cursor, builder);
  nlohmann::json::sax_parse(CursorIterator(&cursor), CursorIterator(), &handler);
  return builder.Finish();
}

}  // namespace tautline
