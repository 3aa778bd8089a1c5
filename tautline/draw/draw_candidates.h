// Pictures of several workspaces side by side: the best ways to lay the cables, and what futures make of one.
#ifndef TAUTLINE_DRAW_DRAW_CANDIDATES_H_
#define TAUTLINE_DRAW_DRAW_CANDIDATES_H_

#include <span>
#include <string>
#include <vector>

#include "tautline/planners/cable_workspace/futures.h"

namespace tautline {

/// A way to lay the cables.
struct Candidate {
  const WorkspaceBoundary* boundary;        ///< Never null.
  const FutureOutcomes* futures = nullptr;  ///< Where the scene has some.
};

/// What the picture of the best boundaries says around them.
struct CandidatesPicture {
  std::vector<Candidate> candidates;  ///< Best first; those beyond the first dozen are counted only.
  std::size_t found = 0;              ///< How many there are in all.
  bool complete = true;               ///< None is missing.
  double max_boundary = 0;            ///< Metres.
  std::string explanation;            ///< Why there is none, or why some may be missing; may be empty.
};

/// The candidates, the best first, each on a small map. Deterministic.
std::string DrawCandidates(const Scene& scene, const FreeSpace& space, const CandidatesPicture& picture);

/// A workspace now and in every future, each on a small map with its probability and its area. Deterministic.
std::string DrawFutures(const Scene& scene, const FreeSpace& space, const WorkspaceBoundary& boundary,
                        const Futures& futures, const FutureOutcomes& outcomes);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_CANDIDATES_H_
