#include "apps/cli/training_folder.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "apps/cli/output_file.h"
#include "tautline/scene/text_file.h"

namespace tautline::cli {
namespace {

constexpr char kOptions[] = "options.json";
constexpr std::size_t kMostBytes = std::size_t{1} << 32;

/// What a training writes, in its folder or in those of its seeds.
constexpr std::array<std::string_view, 10> kFiles{kOptions,          "policy.onnx", "result.json", "curves.svg",
                                                  "visits.svg",      "path.svg",    "checkpoint",  "episodes.csv",
                                                  "evaluations.csv", "visits.csv"};

/// Whether a name is that of the temporary file of one of these: "checkpoint.Ab3xYz".
bool IsTemporary(std::string_view name) {
  constexpr std::size_t kEnding = 7;
  if (name.size() <= kEnding || name[name.size() - kEnding] != '.') return false;
  return std::find(kFiles.begin(), kFiles.end(), name.substr(0, name.size() - kEnding)) != kFiles.end();
}

/// Removes the temporary files that a training left behind when it was killed.
void RemoveTemporaries(const std::string& path) {
  std::vector<std::filesystem::path> left;
  std::error_code fault;
  for (std::filesystem::recursive_directory_iterator at(path, fault), end; !fault && at != end; at.increment(fault)) {
    if (at.depth() < 2 && at->is_regular_file(fault) && IsTemporary(at->path().filename().string())) {
      left.push_back(at->path());
    }
  }
  for (const auto& file : left) std::filesystem::remove(file, fault);
}

Expected<void> MakeFolder(const std::string& path) {
  std::error_code fault;
  std::filesystem::create_directories(path, fault);
  if (!fault) return {};
  return tl::unexpected(Error{ErrorCode::kUnreadable, "cannot be made (" + fault.message() + ")", path});
}

}  // namespace

Expected<std::string> TrainingFolder::Open(const std::string& path, const std::string& options, bool resume) {
  const std::string file = path + "/" + kOptions;
  std::error_code fault;  // What cannot be looked at cannot be written either, and that says why.
  if (std::filesystem::exists(file, fault)) {
    if (!resume) return InvalidInput("holds a training; give --resume to go on with it, or another folder", path);
    const auto kept = ReadTextFile(file, kMostBytes);
    if (!kept) return tl::unexpected(kept.error());
    if (*kept != options) {
      return InvalidInput(
          "is of a training with another scene, other options, seeds or kernels; give the same, or "
          "another folder",
          file);
    }
    RemoveTemporaries(path);
    return path;
  }
  if (std::filesystem::exists(path, fault) && !std::filesystem::is_empty(path, fault) && !fault) {
    return InvalidInput("is no training and not empty; give a folder that is new or empty", path);
  }
  if (const auto made = MakeFolder(path); !made) return tl::unexpected(made.error());
  const auto written = TrainingFolder(path).Write({{kOptions, options}});
  if (!written) return tl::unexpected(written.error());
  return path;
}

Expected<void> TrainingFolder::Write(const std::vector<File>& files) {
  const std::lock_guard lock(mutex_);
  for (std::size_t first = 0; first < files.size(); first += OutputFiles::kMost) {
    OutputFiles outputs;
    for (std::size_t i = first; i < std::min(files.size(), first + OutputFiles::kMost); ++i) {
      const std::string path = PathOf(files[i].first);
      auto made = MakeFolder(std::filesystem::path(path).parent_path().string());
      if (!made) return made;
      if (auto added = outputs.Add(path, files[i].second); !added) return added;
    }
    if (auto placed = outputs.Commit(); !placed) return placed;
  }
  return {};
}

Expected<std::optional<std::string>> TrainingFolder::Checkpoint(std::uint64_t seed) const {
  const std::string path = PathOf(Of(seed, "checkpoint"));
  std::error_code fault;
  if (!std::filesystem::exists(path, fault)) return std::optional<std::string>();
  auto bytes = ReadTextFile(path, kMostBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  return std::optional<std::string>(*std::move(bytes));
}

std::string TrainingFolder::Of(std::uint64_t seed, const std::string& name) {
  return "seed-" + std::to_string(seed) + "/" + name;
}

}  // namespace tautline::cli
