// One of the independent searches that together look for the best places of winches.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_PLACE_JOB_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_PLACE_JOB_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "tautline/base/stop.h"
#include "tautline/planners/cable_workspace/placement.h"

namespace tautline {

/// What makes a job: the same for all jobs of a search.
struct PlaceJobOptions {
  std::int64_t evaluations = 300;  ///< After which a job ends at the latest.
  std::uint64_t seed = 1;          ///< From which every job draws its own start.
  KeepGoing keep_going = {};       ///< Asked before each evaluation; at a no there is no result.
};

/// The moment at which a job found something better.
struct PlaceGain {
  std::int64_t evaluation = 0;  ///< The number of the evaluation in its job, from 1 on.
  PlacementWorth worth;         ///< What it found.

  /// Whether moment and worth are equal to the bit.
  friend bool operator==(const PlaceGain&, const PlaceGain&) = default;
};

/// What a job found. Plain numbers, so that it can be written down and read again.
struct PlaceJob {
  std::size_t job = 0;            ///< Its number, from 0 on.
  std::vector<double> start;      ///< The positions that it began with, ascending, metres.
  std::vector<double> positions;  ///< The best it found; empty when no placement had any valid boundary.
  std::vector<PlaceGain> gains;   ///< Each better than the one before; the last is what `positions` are worth.
  std::int64_t evaluations = 0;   ///< How many it made.
  std::int64_t incomplete = 0;    ///< How many of them ran out of budget.

  /// Whether all is equal to the bit.
  friend bool operator==(const PlaceJob&, const PlaceJob&) = default;
};

/// The positions that a job begins with: job 0 spreads the anchors evenly, job 1 stands each on a corner of
/// its own as far as corners go, the other odd jobs one or more of them; where the rest stands is drawn.
std::vector<double> PlaceStart(const PlacementGround& ground, std::uint64_t seed, std::size_t job);

/// Searches from one start: a pattern search that moves one anchor at a time to either side; where that is no better,
/// one to the corner of the outline next to it, two neighbours so that the line between them turns about a task or a
/// corner, or all of them in a direction that it draws. A step that no move improves is halved [Torczon1997]. Depends
/// on ground, seed and job alone. Nothing when it was stopped.
std::optional<PlaceJob> RunPlaceJob(const PlacementGround& ground, const PlaceJobOptions& options, std::size_t job);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_PLACE_JOB_H_
