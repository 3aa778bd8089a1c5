// Output that is there whole or not at all.
#ifndef APPS_CLI_OUTPUT_FILE_H_
#define APPS_CLI_OUTPUT_FILE_H_

#include <string>
#include <string_view>

#include "tautline/base/error.h"

namespace tautline::cli {

/// Writes the bytes to a temporary file beside `path`, or beside what a link of that name points to, and renames it.
/// Nothing is left behind on an error, nor when the
/// program is interrupted. Errors: kUnreadable, with the system's reason.
[[nodiscard]] Expected<void> WriteFile(const std::string& path, std::string_view bytes);

/// Writes and flushes. Errors: a full disk, a closed pipe.
[[nodiscard]] Expected<void> WriteStandardOutput(std::string_view bytes);

/// From now on Ctrl-C, SIGTERM and SIGHUP remove the temporary file, if there is one, and end the program with status
/// 128 + the signal's number, 130 for Ctrl-C. A closed pipe ends it silently, as programs in a pipeline do.
void HandleSignals();

}  // namespace tautline::cli

#endif  // APPS_CLI_OUTPUT_FILE_H_
