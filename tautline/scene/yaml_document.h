// YAML text as a Document, every value with its line. Native: needs yaml-cpp.
#ifndef TAUTLINE_SCENE_YAML_DOCUMENT_H_
#define TAUTLINE_SCENE_YAML_DOCUMENT_H_

#include <string>
#include <string_view>

#include "tautline/base/error.h"
#include "tautline/scene/document.h"

namespace tautline {

/// Reads one YAML document. Plain scalars are typed as in the core schema of YAML 1.2 (null, true and false, decimal
/// numbers; `yes` and `on` are texts, and so is everything in quotes); aliases are replaced by copies. `file` stands
/// in the errors: kInvalidInput for a fault of syntax, a key that stands twice in a map or is not a text, `.nan`,
/// `.inf`, a number too large for a double, a second document; kLimitExceeded beyond the limits of document.h, to
/// which the copies made for aliases count. O(length + copies).
[[nodiscard]] Expected<Document> ParseYaml(std::string_view text, const std::string& file);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_YAML_DOCUMENT_H_
