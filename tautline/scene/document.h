// A tree of values with positions: the common form of YAML and JSON, before anything is known about scenes.
#ifndef TAUTLINE_SCENE_DOCUMENT_H_
#define TAUTLINE_SCENE_DOCUMENT_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tautline/base/error.h"

namespace tautline {

// Limits of a document, far above any scene and low enough to refuse files made to exhaust memory.

inline constexpr std::size_t kMaxDocumentBytes = std::size_t{64} << 20;  ///< Of its text.
inline constexpr std::size_t kMaxDocumentValues = 6'000'000;             ///< Values, each element of a list counted.
inline constexpr std::size_t kMaxDocumentDepth = 64;                     ///< Lists and maps within each other.

/// A place in a text; both count from 1.
struct Position {
  int line = 1;    ///< From the start of the text.
  int column = 1;  ///< From the start of the line.
};

/// A key of a map and where it stands.
struct DocumentKey {
  std::string name;   ///< As written, without quotes.
  Position position;  ///< Where it starts.
};

/// One value: nothing, true or false, a finite number, a text, a list or a map.
struct Document {
  /// What a value is.
  enum class Kind { kNull, kBool, kNumber, kString, kList, kMap };

  Kind kind = Kind::kNull;        ///< Which of the members below has a meaning.
  Position position;              ///< Where it starts.
  bool boolean = false;           ///< Of kBool.
  double number = 0;              ///< Of kNumber; finite.
  std::string text;               ///< Of kString.
  std::vector<Document> items;    ///< The elements of a list, or the values of a map.
  std::vector<DocumentKey> keys;  ///< Of a map, in the order of the file; keys[i] belongs to items[i]. Unique.

  /// Whether it is of this kind.
  bool is(Kind k) const { return kind == k; }

  /// The value of a key of a map; null when there is none. O(keys).
  const Document* Find(std::string_view key) const;
};

/// The value in a few words for a message: "the number 5", "the text 'abc'", "a list of 3", "a map", "nothing".
std::string Describe(const Document& value);

/// The text with blanks in the place of line ends and other control characters: messages are one line.
std::string OneLine(std::string text);

/// A text in quotes, on one line and shortened to 40 bytes.
std::string Quoted(std::string_view text);

/// Builds a document from the events of a parser and keeps the limits. After the first failure every call returns
/// false and changes nothing. Calls must be well nested; keys alternate with values inside a map.
class DocumentBuilder {
 public:
  /// `file` stands in the errors.
  explicit DocumentBuilder(std::string file) : file_(std::move(file)) {}

  bool Null(Position at);                                                   ///< A value that is nothing.
  bool Bool(bool value, Position at);                                       ///< True or false.
  bool Number(double value, Position at);                                   ///< Fails on NaN and infinity.
  bool String(std::string value, Position at);                              ///< A text, UTF-8.
  bool StartList(Position at) { return Start(Document::Kind::kList, at); }  ///< Until End, values are elements.
  bool StartMap(Position at) { return Start(Document::Kind::kMap, at); }    ///< Until End, keys and values.
  bool Key(std::string name, Position at);                                  ///< Of the value that comes next.
  bool End();  ///< Of the innermost list or map. Fails on a map with a key that stands twice.
  bool Copy(const Document& value, Position at);  ///< A whole value again; it counts against the limit of values.

  /// Counts a value against the limit again, for a copy that the caller keeps.
  bool Charge(const Document& value, Position at);

  /// Records a failure (the first one stays) and returns false.
  bool Fail(std::string message, Position at, ErrorCode code = ErrorCode::kInvalidInput);

  /// Whether the innermost is a map that waits for a key.
  bool expects_key() const;
  /// Whether a call has failed.
  bool failed() const { return failed_; }
  /// How many lists and maps are open.
  std::size_t depth() const { return open_.size(); }

  /// The value that was completed last. Requires one.
  const Document& last() const;

  /// The document, or the first failure; a failure too when there was no value at all.
  Expected<Document> Finish();

 private:
  bool Start(Document::Kind kind, Position at);
  bool Add(Document value);
  bool Count(std::size_t values, Position at);

  std::string file_;
  std::vector<Document> open_;  ///< Lists and maps not yet ended, outermost first.
  Document root_;
  bool has_root_ = false;
  std::size_t values_ = 0;
  bool failed_ = false;
  Error error_;
};

}  // namespace tautline

#endif  // TAUTLINE_SCENE_DOCUMENT_H_
