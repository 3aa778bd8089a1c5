// Bad input as a value: what is wrong, where it stands, and how to mend it.
#ifndef TAUTLINE_BASE_ERROR_H_
#define TAUTLINE_BASE_ERROR_H_

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace tautline {

/// What kind of fault an Error tells of.
enum class ErrorCode {
  kInvalidInput,   ///< A file or an argument says something that cannot be meant.
  kUnreadable,     ///< A file is missing or cannot be opened.
  kUnsupported,    ///< Well formed, but outside of what tautline reads.
  kLimitExceeded,  ///< Larger than the stated limits.
  kStopped,        ///< The caller asked to stop.
};

/// One line for a person: `where` is "file:line", a key or an argument (may be empty); `message` says what is wrong
/// and how to mend it.
struct Error {
  ErrorCode code = ErrorCode::kInvalidInput;  ///< What kind of fault it is.
  std::string message;                        ///< What is wrong and how to mend it.
  std::string where;                          ///< "file:line", a key or an argument; may be empty.
};

/// "where: message", or the message alone.
inline std::string ToString(const Error& error) {
  return error.where.empty() ? error.message : error.where + ": " + error.message;
}

/// A value, or the Error that says why there is none.
template <class T>
using Expected = tl::expected<T, Error>;

/// Shorthand for returning an error: `return InvalidInput("length is negative", "scene.yaml:3")`.
inline tl::unexpected<Error> InvalidInput(std::string message, std::string where = "") {
  return tl::unexpected<Error>(Error{ErrorCode::kInvalidInput, std::move(message), std::move(where)});
}

}  // namespace tautline

#endif  // TAUTLINE_BASE_ERROR_H_
