// The picture of a motion inside a workspace.
#ifndef TAUTLINE_DRAW_DRAW_MOVE_H_
#define TAUTLINE_DRAW_DRAW_MOVE_H_

#include <string>

#include "tautline/planners/cable_workspace/move.h"
#include "tautline/scene/free_space.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// What the picture of a motion shows.
struct MovePicture {
  const Anchors& anchors;                        ///< Of all cables.
  const WorkspaceBoundary& boundary;             ///< Of the workspace.
  Point start;                                   ///< As asked for.
  Point goal;                                    ///< As asked for.
  const MoveOptions& options;                    ///< How the robot drives.
  const tl::expected<Move, OutsideFault>& move;  ///< Or why there is none.
};

/// The workspace with the robot's path and its taut cables: at the start, and thin at a few later times. Below, over
/// time, the length of each cable and how fast its winch pays out or reels in; rings mark where a cable
/// switches its corner, on the path too. Without a motion, what is outside. Deterministic.
std::string DrawMove(const Scene& scene, const FreeSpace& space, const MovePicture& picture);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_MOVE_H_
