// Output that is there whole or not at all.
#ifndef APPS_CLI_OUTPUT_FILE_H_
#define APPS_CLI_OUTPUT_FILE_H_

#include <string>
#include <string_view>

#include "tautline/base/error.h"

namespace tautline::cli {

/// Writes the bytes to a temporary file beside `path` and renames it. Nothing is left behind on an error, nor when the
/// program is interrupted. Errors: kUnreadable, with the system's reason.
[[nodiscard]] Expected<void> WriteFile(const std::string& path, std::string_view bytes);

/// Writes and flushes. Errors: a full disk, a closed pipe.
[[nodiscard]] Expected<void> WriteStandardOutput(std::string_view bytes);

/// From now on Ctrl-C and SIGTERM remove the temporary file, if there is one, and end the program with status 130; a
/// closed pipe is an error to be told, not a signal.
void HandleSignals();

}  // namespace tautline::cli

#endif  // APPS_CLI_OUTPUT_FILE_H_
