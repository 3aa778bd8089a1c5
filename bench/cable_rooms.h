// Rooms with winches on their walls, for the benchmarks of cable workspaces.
#ifndef TAUTLINE_BENCH_CABLE_ROOMS_H_
#define TAUTLINE_BENCH_CABLE_ROOMS_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tautline/planners/cable_workspace/cable_ground.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// A world and where its winches stand, in order around it.
struct CableRoom {
  World world;
  std::vector<Point> anchors;
};

/// 200 m x 200 m with two convex obstacles and a concave one, and a winch in each corner: a room like those of
/// [Wang2018, Sec. IV], whose coordinates were not published.
CableRoom ThreeObstacleRoom();

struct RandomRoomOptions {
  std::size_t anchors = 8;
  std::size_t obstacles = 20;
  double band = 50;  ///< Metres; no obstacle's centre is farther away from the walls. 100: they stand everywhere.
  std::uint64_t seed = 1;
};

/// 200 m x 200 m with stars of 4 m to 10 m, at random at least 6 m apart and 6 m away from the walls, and winches
/// evenly around the walls, the first one in a corner. The same options give the same room; fewer obstacles are the
/// first ones of more.
CableRoom RandomCableRoom(const RandomRoomOptions& options);

/// A room that is ready to be asked.
struct PreparedCableRoom {
  /// Requires that all winches stand on free ground.
  explicit PreparedCableRoom(const CableRoom& room);

  CableGround ground;
  Anchors anchors;
  double shortest;  ///< The length of its shortest valid boundary, metres.
};

}  // namespace tautline

#endif  // TAUTLINE_BENCH_CABLE_ROOMS_H_
