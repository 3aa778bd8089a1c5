// Where to put the socket: every candidate's manifold, and which is best.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_BEST_BASE_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_BEST_BASE_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tautline/planners/grid_manifold/grid_manifold.h"

namespace tautline {

/// Which cells are candidates.
enum class BaseCandidates {
  kLattice,  ///< Every so many columns and rows.
  kWalls,    ///< Cells beside blocked ones, thinned out to the same lattice's squares.
};

/// The candidates, row by row: of each square of `stride` x `stride` cells the free cell nearest to its middle, with
/// kWalls of those that share a side with a blocked cell or the border. Equally near ones: the first. Requires stride
/// >=
/// 1. O(cells).
std::vector<GridCell> CandidateBases(const CellGround& ground, BaseCandidates kind, int stride);

/// What is asked of every candidate.
struct BaseTrialOptions {
  double length_m = 0;                               ///< Of the tether.
  Connectivity connectivity = Connectivity::kEight;  ///< How the robot steps.
  bool deadlocks = false;                            ///< Also look for deadlocks, which takes much longer.
  std::int64_t max_vertices = 20'000'000;            ///< Of each manifold.
  std::int64_t max_bytes = std::int64_t{2} << 30;    ///< Of each manifold.
};

/// What one candidate is worth.
struct BaseTrial {
  std::size_t job = 0;         ///< Its number among the candidates.
  GridCell base;               ///< The candidate.
  std::int64_t cells = 0;      ///< Cells that the tether reaches in some class.
  std::int64_t vertices = 0;   ///< Pairs of cell and class.
  std::int64_t deadlocks = 0;  ///< How many there are.
  std::int64_t closed = 0;     ///< Vertices that they close.
  std::int64_t lost = 0;       ///< Cells of which they close all vertices.
  bool complete = true;        ///< No budget ran out.

  /// Whether all members are equal.
  friend bool operator==(const BaseTrial&, const BaseTrial&) = default;
};

/// Builds the manifold of one candidate. Requires a free base. Cost: that of GridManifold::Build and DeadlockAreas.
BaseTrial TryBase(const CellGround& ground, GridCell base, const BaseTrialOptions& options);

/// What makes a base the best.
enum class BaseObjective {
  kArea,      ///< The most cells reached; then the most vertices.
  kDeadlock,  ///< The least closed vertices; then the most cells reached.
};

/// For kDeadlock, a base counts where it reaches this share of the most cells that any one reaches: in a corner that
/// the robot can hardly leave there are no deadlocks either.
inline constexpr double kLeastReachShare = 0.9;

/// The trials from the best on, those that do not count last; equal ones by number. Those that are not complete are
/// left out. O(n log n).
std::vector<BaseTrial> RankBases(std::span<const BaseTrial> trials, BaseObjective objective);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_BEST_BASE_H_
