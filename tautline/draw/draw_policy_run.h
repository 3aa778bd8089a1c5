// The picture and the film of a robot that keeps clear of its cable, and its cable of obstacles.
#ifndef TAUTLINE_DRAW_DRAW_POLICY_RUN_H_
#define TAUTLINE_DRAW_DRAW_POLICY_RUN_H_

#include <string>
#include <vector>

#include "tautline/planners/contact_free/policy_run.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// What there is to see.
struct PolicyRunPicture {
  std::vector<EnvFrame> frames;  ///< In order; empty where the drive could not begin.
  Polyline reference;            ///< May be empty.
  double robot_radius_m = 0.5;   ///< Of the disc.
  bool success = false;          ///< The goal was reached.
  double length_m = 0;           ///< Of the path.
  std::string explanation;       ///< Why it did not succeed; may be empty.
};

/// The picture, as SVG: the path, the reference, robot and cable at some moments [Shimada2024, Fig. 5], and where
/// contacts began. Requires a world with a free space, and a tether. Deterministic.
std::string DrawPolicyRun(const Scene& scene, const PolicyRunPicture& picture);

/// The same as a film: robot and cable move, over and over. Deterministic.
std::string AnimatePolicyRun(const Scene& scene, const PolicyRunPicture& picture);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_POLICY_RUN_H_
