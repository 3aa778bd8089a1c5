// States of a drive that are as good as one.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_STATE_KEY_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_STATE_KEY_H_

#include <cstdint>

#include "tautline/planners/grid_manifold/robot_driver.h"

namespace tautline {

/// Equal for states whose robots stand at the same vertex, so that their cables have the same class, and whose cables
/// run through the same squares of `coarse_m` in the same order. Different states may have equal keys by chance, about
/// n² / 2^65 for n states. O(links).
std::uint64_t StateKey(const DriveState& state, double coarse_m);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_STATE_KEY_H_
