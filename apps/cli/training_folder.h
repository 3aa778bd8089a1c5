// The folder of a training: its options, and for each seed what it came to and where it is.
#ifndef APPS_CLI_TRAINING_FOLDER_H_
#define APPS_CLI_TRAINING_FOLDER_H_

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tautline/base/error.h"

namespace tautline::cli {

/// Files of a training. Several threads may write at a time; each file appears whole or not at all.
class TrainingFolder {
 public:
  /// A name within the folder, and bytes.
  using File = std::pair<std::string, std::string>;

  /// Makes the folder, or goes on in it; what a killed training left of half-written files is removed then. `options`
  /// is kept in options.json and tells trainings apart. Errors: the folder holds a training and `resume` is false, or
  /// one with other options; it cannot be made.
  [[nodiscard]] static Expected<std::string> Open(const std::string& path, const std::string& options, bool resume);

  /// At a path that Open accepted.
  explicit TrainingFolder(std::string path) : path_(std::move(path)) {}

  /// Writes files, those of a call together. Names may lie in the folder of a seed. Errors: as OutputFiles.
  [[nodiscard]] Expected<void> Write(const std::vector<File>& files);

  /// The checkpoint of a seed; none where there is none yet. Errors: it cannot be read.
  [[nodiscard]] Expected<std::optional<std::string>> Checkpoint(std::uint64_t seed) const;

  /// "seed-3/policy.onnx".
  static std::string Of(std::uint64_t seed, const std::string& name);
  /// Its path.
  std::string PathOf(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
  std::mutex mutex_;  ///< There is one set of temporary files at a time.
};

}  // namespace tautline::cli

#endif  // APPS_CLI_TRAINING_FOLDER_H_
