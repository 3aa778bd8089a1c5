// Lengths of paths on a grid as integers that compare exactly.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_LATTICE_DISTANCE_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_LATTICE_DISTANCE_H_

#include <cstdint>

namespace tautline {

/// The length of a path on a grid: straight steps times kStraightStep plus diagonal steps times kDiagonalStep. The two
/// are a convergent of the square root of 2, so that sums compare as a + b sqrt(2) does, exactly, up to 47,000
/// cells: two such lengths differ by more than the convergent's error, 3.2e-10 a step.
using LatticeDistance = std::int32_t;

inline constexpr LatticeDistance kStraightStep = 33461;  ///< A step to a cell that shares a side.
inline constexpr LatticeDistance kDiagonalStep = 47321;  ///< A step to a cell that shares a corner.
/// Longest tether, cells: sums of two such lengths are told apart and fit.
inline constexpr double kFarthestCells = 23'000;
/// Not reached. Steps of a tile can be added to it without overflow.
inline constexpr LatticeDistance kUnreached = INT32_MAX - (1 << 23);

/// The length in cells, correctly rounded but for the last bits. Requires a length of a path, twice kFarthestCells at
/// most.
double CellsOf(LatticeDistance distance);

/// The largest distance that counts as no longer than `cells`, which is 0 or more: up to kLengthTolerance longer, as
/// elsewhere, and kFarthestCells at most.
LatticeDistance LimitOf(double cells);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_LATTICE_DISTANCE_H_
