#include "apps/answers/part_file.h"

#include <cstdio>
#include <map>
#include <set>
#include <utility>

namespace tautline {
namespace {

Expected<Json> ParsePart(const PartKind& kind, std::string_view text, const std::string& name) {
  auto json = ReadingPart(kind, name, [text] { return Json::parse(text); });
  if (!json) return json;
  if (!json->is_object() || !json->contains("part")) return NoPart(kind, name, "it has no key `part`");
  if (json->at("part") != kind.version) {
    return InvalidInput("was written by another version of tautline: run its shard again", name);
  }
  if (json->value("command", Json()) != kind.command) return NoPart(kind, name, "another command wrote it");
  return json;
}

/// The first thing in which two searches differ: "its seed is 2 instead of 1".
std::string Difference(const Json& found, const Json& wanted) {
  for (const auto& [key, value] : wanted.items()) {
    if (!found.contains(key) || found[key] != value) {
      return "its " + key + " is " + (found.contains(key) ? found[key].dump() : "unknown") + " instead of " +
             value.dump();
    }
  }
  return "";
}

}  // namespace

Expected<Shard> ParseShard(const std::string& text) {
  unsigned index = 0, count = 0;
  char rest = 0;
  const bool is_fraction = std::sscanf(text.c_str(), "%9u/%9u%c", &index, &count, &rest) == 2;
  if (is_fraction && index >= 1 && index <= count) return Shard{index - 1, count};
  return InvalidInput("must be I/N with I from 1 to N, such as 2/16, not '" + text + "'", "--shard");
}

std::vector<std::size_t> JobsLeft(std::size_t jobs, const Shard& shard, std::span<const std::size_t> done) {
  const std::set<std::size_t> numbers(done.begin(), done.end());
  std::vector<std::size_t> left;
  for (std::size_t job = shard.index; job < jobs; job += shard.count) {
    if (numbers.count(job) == 0) left.push_back(job);
  }
  return left;
}

Json PartJson(const PartKind& kind, Json done, bool complete) {
  return {{"command", kind.command}, {"status", complete ? "solved" : "budget_exceeded"},
          {"part", kind.version},    {"scene", kind.digest},
          {"search", kind.search},   {"done", std::move(done)}};
}

Expected<Json> ReadPartSearch(const PartKind& kind, std::string_view text, const std::string& name) {
  auto json = ParsePart(kind, text, name);
  if (!json) return json;
  return ReadingPart(kind, name, [&json]() -> Json { return json->at("search"); });
}

Expected<Json> ReadPartJobs(const PartKind& kind, std::string_view text, const std::string& name) {
  auto json = ParsePart(kind, text, name);
  if (!json) return json;
  if (json->value("search", Json()) != kind.search) {
    return InvalidInput("belongs to another search: " + Difference(json->value("search", Json::object()), kind.search) +
                            "; join parts of one search only",
                        name);
  }
  if (json->value("scene", Json()) != kind.digest) {
    return InvalidInput("was made for another scene: world, tasks or futures differ; run its shard again", name);
  }
  return ReadingPart(kind, name, [&json]() -> Json { return json->at("done"); });
}

tl::unexpected<Error> NoPart(const PartKind& kind, const std::string& name, const std::string& why) {
  return InvalidInput(
      "is no part of `tautline " + kind.command + "` (" + why + "): name a file that --checkpoint wrote", name);
}

Expected<void> CheckParts(std::size_t jobs, std::span<const PartNumbers> parts, bool unfinished) {
  std::map<std::size_t, std::string> part_of;
  std::vector<std::size_t> done;
  for (const PartNumbers& part : parts) {
    for (const std::size_t job : part.jobs) {
      const auto [known, is_new] = part_of.emplace(job, part.name);
      done.push_back(job);
      if (is_new) continue;
      return InvalidInput("holds job " + std::to_string(job) + ", which " +
                              (known->second == part.name ? "it holds twice" : known->second + " holds as well") +
                              ": name each part once",
                          part.name);
    }
  }
  const auto left = JobsLeft(jobs, {}, done);
  if (left.empty() || unfinished) return {};
  return InvalidInput("of " + std::to_string(jobs) + " jobs " + std::to_string(left.size()) +
                      " stand in no part, job " + std::to_string(left[0]) +
                      " first: run their shards too, or join what there is with --unfinished");
}

}  // namespace tautline
