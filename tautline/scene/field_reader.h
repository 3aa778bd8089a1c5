// Typed values out of a Document, with errors that say where, what and how to mend it.
#ifndef TAUTLINE_SCENE_FIELD_READER_H_
#define TAUTLINE_SCENE_FIELD_READER_H_

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tautline/base/error.h"
#include "tautline/geometry/polygon.h"
#include "tautline/scene/document.h"
#include "tautline/scene/number_fault.h"

namespace tautline {

/// The points of one scene, all lists together.
inline constexpr std::size_t kMaxScenePoints = 1'000'000;

/// Reads numbers, texts and points from the values of one file and remembers the first error; after it, every call
/// returns a default value at once, so that a reader can be written straight down and asks ok() at the end. `what`
/// names a value in messages: "tether.length".
class FieldReader {
 public:
  /// `file` stands in the errors.
  explicit FieldReader(std::string file) : file_(std::move(file)) {}

  /// Whether there was no error.
  bool ok() const { return ok_; }
  /// The first error. Requires !ok().
  const Error& error() const { return error_; }

  /// "scene.yaml:7".
  std::string Where(Position at) const { return file_ + ":" + std::to_string(at.line); }

  /// Records the error unless there is one already.
  void Fail(Position at, std::string message, ErrorCode code = ErrorCode::kInvalidInput);

  /// The same for an error that another reader found.
  void Fail(Error error);

  /// Records what is wrong with `what`, if anything is.
  void Check(const std::optional<Fault>& fault, Position at, std::string_view what);

  /// Whether the value is a map; records an error when not.
  bool IsMap(const Document& value, std::string_view what);

  /// Whether the value is a list; records an error when not.
  bool IsList(const Document& value, std::string_view what);

  /// Refuses keys that are not known, with the nearest known one as a hint. O(keys * known).
  void KnownKeys(const Document& map, std::string_view what, const std::vector<std::string_view>& known);

  /// The value of a key that must be there; null after an error.
  const Document* Required(const Document& map, std::string_view what, std::string_view key);

  /// A number; 0 after an error.
  double ReadNumber(const Document& value, std::string_view what);
  double ReadPositive(const Document& value, std::string_view what);     ///< > 0.
  double ReadNonNegative(const Document& value, std::string_view what);  ///< >= 0.
  std::string ReadText(const Document& value, std::string_view what);    ///< Not empty.

  /// A name of an obstacle or a robot: a text that is not empty and holds neither blanks nor '^'.
  std::string ReadName(const Document& value, std::string_view what);

  /// Counts towards kMaxScenePoints; an error beyond it.
  void CountPoint(Position at);

  /// A list of two numbers: x and y, metres.
  Point ReadPoint(const Document& value, std::string_view what);

  /// A list of `at_least` points or more. All lists of a reader together hold no more than kMaxScenePoints.
  Polyline ReadPoints(const Document& value, std::string_view what, std::size_t at_least);

 private:
  std::string file_;
  bool ok_ = true;
  Error error_;
  std::size_t points_ = 0;
};

/// The name among `known` that `name` was probably meant to be; empty when none is near.
std::string_view NearestName(std::string_view name, std::span<const std::string_view> known);

/// "what[3]", counting from 1.
std::string Element(std::string_view what, std::size_t index);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_FIELD_READER_H_
