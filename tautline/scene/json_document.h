// JSON text as a Document, every value with its line.
#ifndef TAUTLINE_SCENE_JSON_DOCUMENT_H_
#define TAUTLINE_SCENE_JSON_DOCUMENT_H_

#include <string>
#include <string_view>

#include "tautline/base/error.h"
#include "tautline/scene/document.h"

namespace tautline {

/// Reads one JSON value (RFC 8259; a byte order mark is skipped). `file` stands in the errors: kInvalidInput for a
/// fault of syntax, a key that stands twice in a map, or a number too large for a double; kLimitExceeded beyond the
/// limits of document.h. O(length).
[[nodiscard]] Expected<Document> ParseJson(std::string_view text, const std::string& file);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_JSON_DOCUMENT_H_
