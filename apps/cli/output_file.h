// Output that is there whole or not at all.
#ifndef APPS_CLI_OUTPUT_FILE_H_
#define APPS_CLI_OUTPUT_FILE_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tautline/base/error.h"

namespace tautline::cli {

/// Files of one answer, which appear together or not at all. Each is written to a temporary file beside its path, or
/// beside what a link of that name points to; `Commit` renames them all. Until then nothing that was there has changed,
/// and temporary files vanish with this object and when a signal ends the program.
class OutputFiles {
 public:
  static constexpr std::size_t kMost = 4;  ///< Files of one answer.

  OutputFiles() = default;
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;
  ~OutputFiles();

  /// Writes the bytes, whole. A device or a pipe, such as /dev/null, cannot be replaced; it is written to at once.
  /// Errors: kUnreadable, with the system's reason. Requires fewer than kMost files before it, and no other object.
  [[nodiscard]] Expected<void> Add(const std::string& path, std::string_view bytes);

  /// Puts the files in place. After an error everything is as it was, as far as the file system can exchange files.
  [[nodiscard]] Expected<void> Commit();

 private:
  struct File {
    std::string path;    ///< As given.
    std::string target;  ///< Where links lead.
    bool existed = false;
  };

  int Place(std::size_t index);
  void TakeBack(std::size_t index);

  std::vector<File> files_;
};

/// Writes and flushes. Errors: a full disk, a closed pipe.
[[nodiscard]] Expected<void> WriteStandardOutput(std::string_view bytes);

/// The same for one line of many: Ctrl-C waits until it is written, so that readers never see a part of a line.
[[nodiscard]] Expected<void> WriteWholeLine(std::string_view line);

/// From now on Ctrl-C, SIGTERM, SIGHUP and a closed pipe remove the temporary files, if there are any, and end the
/// program silently with status 128 + the signal's number: 130 for Ctrl-C, 141 for a closed pipe. A file that grows
/// beyond the user's limit (ulimit -f) is an error of OutputFiles::Add.
void HandleSignals();

}  // namespace tautline::cli

#endif  // APPS_CLI_OUTPUT_FILE_H_
