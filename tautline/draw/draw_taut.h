// The picture of a cable pulled tight.
#ifndef TAUTLINE_DRAW_DRAW_TAUT_H_
#define TAUTLINE_DRAW_DRAW_TAUT_H_

#include <string>

#include "tautline/homotopy/taut_path.h"
#include "tautline/scene/free_space.h"

namespace tautline {

/// What the picture shows beside the ground.
struct TautPicture {
  Polyline laid;  ///< The cable as it lies, metres, base first.
  TautPath taut;  ///< The same cable pulled tight.
};

/// The picture, as SVG, of a laid cable and its taut curve, with the rays of the obstacles in its
/// word. `space` is the free space of the scene's world. Deterministic.
std::string DrawTaut(const Scene& scene, const FreeSpace& space, const TautPicture& picture);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_TAUT_H_
