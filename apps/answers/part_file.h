// Searches in independent jobs that several machines share: which jobs a machine does, and how it writes them down.
#ifndef APPS_ANSWERS_PART_FILE_H_
#define APPS_ANSWERS_PART_FILE_H_

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "apps/answers/json_values.h"
#include "tautline/base/error.h"

namespace tautline {

/// The share of the jobs that one of several machines does: those whose number is `index` modulo `count`.
struct Shard {
  std::size_t index = 0;  ///< From 0 on.
  std::size_t count = 1;

  bool Has(std::size_t job) const { return job % count == index; }
};

/// "2/16" is the second of sixteen. Errors: the text is no such fraction.
[[nodiscard]] Expected<Shard> ParseShard(const std::string& text);

/// The numbers of a shard's jobs, of `jobs` in all, that are not among those done, ascending.
std::vector<std::size_t> JobsLeft(std::size_t jobs, const Shard& shard, std::span<const std::size_t> done);

/// What the parts of one search have in common.
struct PartKind {
  std::string command;       ///< That writes them, without the program's name.
  int version = 1;           ///< Changes with what a part holds, and with the search that finds it.
  std::uint64_t digest = 0;  ///< Of the scene.
  Json search;               ///< What was asked of the search.
};

/// A part: finished jobs, as JSON, with what they belong to. `complete`: all that were to be done are.
Json PartJson(const PartKind& kind, Json done, bool complete);

/// What was asked of the search that a part belongs to, as JSON. `kind`: command and version. Errors, with `name`: the
/// text is no part, or one of another version.
[[nodiscard]] Expected<Json> ReadPartSearch(const PartKind& kind, std::string_view text, const std::string& name);

/// The jobs of a part, as JSON. Errors, with `name`: as ReadPartSearch, or it belongs to another scene or search.
[[nodiscard]] Expected<Json> ReadPartJobs(const PartKind& kind, std::string_view text, const std::string& name);

/// That a text is no part, and why.
tl::unexpected<Error> NoPart(const PartKind& kind, const std::string& name, const std::string& why);

/// What `read`, which takes JSON apart, makes of a part. Errors, with `name`: it is not as `read` expects.
template <class Read>
auto ReadingPart(const PartKind& kind, const std::string& name, const Read& read) -> Expected<decltype(read())> {
  try {
    return read();
  } catch (const Json::exception& fault) {
    return NoPart(kind, name, fault.what());
  }
}

/// The numbers of the jobs of a part.
struct PartNumbers {
  std::string name;  ///< Of its file.
  std::vector<std::size_t> jobs;
};

/// That every job of a search stands in one part. Errors: a job stands in two of them; unless `unfinished`, one stands
/// in none.
[[nodiscard]] Expected<void> CheckParts(std::size_t jobs, std::span<const PartNumbers> parts, bool unfinished);

}  // namespace tautline

#endif  // APPS_ANSWERS_PART_FILE_H_
