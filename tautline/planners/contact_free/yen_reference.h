// The reference path as the paper finds it: by the k shortest paths of a lattice.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_YEN_REFERENCE_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_YEN_REFERENCE_H_

#include <vector>

#include "tautline/planners/contact_free/select_reference.h"

namespace tautline {

/// How fine, and how many.
struct YenOptions {
  int count = 120;            ///< Of paths each way, k. Positive. [Shimada2024, Sec. 4.1]
  double step_m = 0.5;        ///< The side of a lattice cell, metres. Positive.
  KeepGoing keep_going = {};  ///< Asked now and then; at a no the search throws Stopped.
};

/// The shortest path found of each signature, shortest first [Shimada2024, Alg. 1]: the k shortest simple paths from
/// start to end and as many from end to start, each signature's shortest made shorter by line of sight. Words are those
/// of the rays of `space`; paths are not taut. Errors: as BuildPathLattice. Requires that both points lie in the free
/// space. O(points of the lattice), and YenPaths.
[[nodiscard]] Expected<std::vector<TautPath>> EnumerateSignatures(const TautSpace& space, Point from, Point to,
                                                                  const YenOptions& options = {});

/// The reference path by two dictionaries [Shimada2024, Alg. 2]: paths from the robot, D1, shortest first, and paths
/// from the base, D2, that give the tether's length. A path whose tether D2 lacks counts as one that does not fit, so
/// "too short" is not a proof here. Errors: as BuildPathLattice.
[[nodiscard]] Expected<ReferenceSelection> SelectReferenceByYen(const TautGround& ground, const ReferenceTask& task,
                                                                const YenOptions& options = {});

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_YEN_REFERENCE_H_
