// The picture and the film of a motion on which cable, robot and obstacles touch as little as possible.
#ifndef TAUTLINE_DRAW_DRAW_CONTACT_FREE_H_
#define TAUTLINE_DRAW_DRAW_CONTACT_FREE_H_

#include <string>

#include "tautline/planners/contact_free/driven_motion.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// What there is to see.
struct ContactFreePicture {
  DrivenMotion motion;          ///< Without poses: there is none.
  double robot_radius_m = 0.5;  ///< Of the disc.
  double dt_s = 0.1;            ///< Of a step.
  std::string explanation;      ///< Why there is no motion; may be empty.
};

/// The picture, as SVG: the way, the cable at the end, where cable and robot were in between, where something began to
/// touch. Requires a world with a free space, a tether and a goal. Deterministic.
std::string DrawContactFree(const Scene& scene, const ContactFreePicture& picture);

/// The same as a film. Deterministic. O(frames * nodes of the cable²).
std::string AnimateContactFree(const Scene& scene, const ContactFreePicture& picture);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_CONTACT_FREE_H_
