// What the heuristic of untangling weighs, for people who want to see it [Igarashi2010, Fig. 11].
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_TARGET_TRIALS_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_TARGET_TRIALS_H_

#include <cstddef>
#include <optional>
#include <vector>

#include "tautline/planners/grid_manifold/drive.h"

namespace tautline {

/// The ground of a region: each vertex by the cell it lies over.
using RegionCells = std::vector<GridCell>;

/// A candidate, tried.
struct TriedTarget {
  Point at;              ///< Metres.
  double score_m = 0;    ///< The lesser of the ways to the robot and to the region's centre.
  bool clears = false;   ///< On the way there, a way to the goal opens, and a visit succeeds.
  bool touched = false;  ///< The robot would pull its cable under itself.
  Point robot;           ///< Where the robot comes to; where the way opens: there.
  Polyline cable;        ///< From base to robot, then.
  RegionCells region;    ///< What the robot can get to from there.
};

/// All candidates of a state.
struct TargetTrials {
  Point goal;                         ///< Metres.
  Point robot;                        ///< Metres.
  bool open = false;                  ///< The way to the goal is open already.
  Polyline cable;                     ///< From base to robot.
  RegionCells region;                 ///< What the robot can get to.
  std::vector<TriedTarget> targets;   ///< The largest score first.
  std::optional<std::size_t> chosen;  ///< The first that clears, else the one with the largest region.
};

/// Tries every candidate of a state, also those after the first that clears; deadlock areas are open. Requires a goal
/// in a free cell of the manifold's ground. O(candidates * simulating them).
TargetTrials TryTargets(const GridManifold& manifold, const DriveState& state, Point goal, const DriveOptions& options);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_TARGET_TRIALS_H_
