// The picture of a scene as tautline understands it.
#ifndef TAUTLINE_DRAW_DRAW_SHOW_H_
#define TAUTLINE_DRAW_DRAW_SHOW_H_

#include <string>

#include "tautline/scene/free_space.h"

namespace tautline {

/// The picture, as SVG, of a scene: free and blocked ground, separate pieces in tints of their own,
/// what merged and what was joined, base, robot, goal and the laid cable. `space` is the free space
/// of the scene's world. Deterministic.
std::string DrawShow(const Scene& scene, const FreeSpace& space);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_SHOW_H_
