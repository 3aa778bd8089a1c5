// A good order of many tasks, by local search.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_TOUR_SEARCH_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_TOUR_SEARCH_H_

#include <cstdint>
#include <vector>

#include "tautline/base/rng.h"
#include "tautline/base/stop.h"
#include "tautline/planners/cable_workspace/tour_distances.h"

namespace tautline {

/// When a search for a tour ends.
struct TourSearchOptions {
  std::int64_t rounds = 0;    ///< Perturbations to try.
  double good_enough = 0;     ///< The length at which the search ends: a lower bound, metres.
  KeepGoing keep_going = {};  ///< Asked before each round; at a no the search ends.
};

/// Each next task the nearest one, the first among equals. O(tasks^2).
std::vector<std::size_t> NearestNeighbourTour(const TourDistances& distances);

/// Shortens a tour: turns parts of it around and moves parts of up to three tasks elsewhere until neither helps, in
/// either case such that some task comes beside one of its nearest [Bentley1992]. Then, round by round, exchanges two
/// random neighbouring parts, shortens again, and keeps the result unless it is longer [Johnson1997]. The same for the
/// same random numbers. About O(tasks) per round.
std::vector<std::size_t> ImproveTour(const TourDistances& distances, std::vector<std::size_t> order,
                                     const TourSearchOptions& options, Rng& rng);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_TOUR_SEARCH_H_
