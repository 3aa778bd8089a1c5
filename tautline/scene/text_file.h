// The bytes of a file.
#ifndef TAUTLINE_SCENE_TEXT_FILE_H_
#define TAUTLINE_SCENE_TEXT_FILE_H_

#include <cstddef>
#include <string>

#include "tautline/base/error.h"

namespace tautline {

/// Everything in the file. Errors: kUnreadable when there is no such file, it is a folder or it cannot be read;
/// kLimitExceeded when it holds more than `max_bytes`, of which no more are read.
[[nodiscard]] Expected<std::string> ReadTextFile(const std::string& path, std::size_t max_bytes);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_TEXT_FILE_H_
