// A search for the places of winches, of which every job can be run anywhere, and how finished jobs are written down.
#ifndef APPS_ANSWERS_PLACE_SEARCH_H_
#define APPS_ANSWERS_PLACE_SEARCH_H_

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "apps/answers/json_values.h"
#include "apps/answers/part_file.h"
#include "tautline/base/error.h"
#include "tautline/planners/cable_workspace/place_job.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// What is asked of a search, besides its scene.
struct PlaceQuestion {
  std::size_t anchors = 4;
  PlaceObjective objective = PlaceObjective::kArea;
  std::optional<double> max_boundary = {};  ///< Metres; default: that of the scene, or else DefaultMaxBoundary.
  std::int64_t budget = PlacementOptions().budget;
  std::size_t jobs = 64;
  std::int64_t evaluations = PlaceJobOptions().evaluations;  ///< Of each job.
  std::uint64_t seed = PlaceJobOptions().seed;

  friend bool operator==(const PlaceQuestion&, const PlaceQuestion&) = default;
};

/// A search that is ready for its jobs.
struct PlaceSearch {
  PlaceQuestion question;    ///< With the default filled in.
  std::uint64_t digest = 0;  ///< Of the scene.
  PlacementGround ground;

  /// How many jobs there are to do: none where a task can be held by no workspace.
  std::size_t jobs() const { return ground.lost_task() ? 0 : question.jobs; }
};

/// Errors: as PlacementGround::Prepare, with the file of the scene; more than a thousand anchors or a million jobs.
[[nodiscard]] Expected<PlaceSearch> PreparePlaceSearch(const Scene& scene, const PlaceQuestion& question,
                                                       const Watcher& watch = {});

/// A part: finished jobs with what they belong to, sorted by job. `complete`: all that were to be done are.
Json PartJson(const PlaceSearch& search, std::vector<PlaceJob> done, bool complete);

/// What was asked of the search that a part belongs to. Errors, with `name`: the text is no part.
[[nodiscard]] Expected<PlaceQuestion> ReadPartQuestion(std::string_view text, const std::string& name);

/// The jobs of a part. Errors, with `name`: the text is no part, it belongs to another scene or another search, or a
/// job in it cannot be one of this search.
[[nodiscard]] Expected<std::vector<PlaceJob>> ReadPart(const PlaceSearch& search, std::string_view text,
                                                       const std::string& name);

}  // namespace tautline

#endif  // APPS_ANSWERS_PLACE_SEARCH_H_
