// A world after the moves of a future.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_MOVED_WORLD_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_MOVED_WORLD_H_

#include <cstddef>
#include <string>
#include <vector>

#include "tautline/base/error.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// An obstacle is moved straight on, without being turned.
struct ObstacleStep {
  std::size_t obstacle = 0;  ///< By position in the world.
  Point offset;              ///< Where it is then, from where it was before all moves, metres.
  std::size_t move = 0;      ///< The move of the future that this step is of, by position.
};

/// Where everything is after a future, and how it came there.
struct MovedWorld {
  World world;                         ///< Obstacles moved, with their representatives.
  std::vector<Point> offsets;          ///< By obstacle: from where it was, metres.
  std::vector<Point> representatives;  ///< By obstacle: before all moves.
  std::vector<ObstacleStep> steps;     ///< In the order of the moves.
};

/// The scene file's name for a future: "futures[1]".
std::string FutureName(std::size_t future);

/// The scene file's name for a move: "futures[1].moves[2]".
std::string MoveName(std::size_t future, std::size_t move);

/// Moves obstacles one after the other, in the order that the future lists them. An obstacle moves as the points of its
/// path lie to the first of them. That must be its representative, to SamePointTolerance; where the world gives it
/// none, any point in or on the obstacle will do. `future`, the position in the scene, is for messages.
/// Errors: kInvalidInput for an obstacle that there is not, and for a path that has no points or does not start at its
/// obstacle; kLimitExceeded for large coordinates. O(size of the world + points of the paths).
[[nodiscard]] Expected<MovedWorld> MoveObstacles(const World& world, const Future& moves, std::size_t future);

/// Whether p is inside of an obstacle as it is listed, and not on its boundary. O(n).
bool StrictlyInsideObstacle(const Obstacle& obstacle, Point p);

/// The distance from p to an obstacle as it is listed, metres; 0 in or on it. O(n).
double DistanceToObstacle(const Obstacle& obstacle, Point p);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_MOVED_WORLD_H_
