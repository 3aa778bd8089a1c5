// Random worlds for a robot of some size, for tests.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_RANDOM_ROBOT_GROUND_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_RANDOM_ROBOT_GROUND_H_

#include <optional>

#include "tautline/homotopy/random_scene.h"
#include "tautline/planners/contact_free/select_reference.h"

namespace tautline {

/// A place for the robot's centre that is connected with another one, if there is one.
inline std::optional<Point> RandomRobotPlace(Rng& rng, const TautSpace& space, std::optional<Point> connected = {}) {
  for (int attempt = 0; attempt < 100; ++attempt) {
    const Point p = random_scene::OnFineGrid(RandomPoint(rng, space.free_space().box));
    const auto place = space.Locate(p);
    if (!place || space.mesh().Sectors(*place).size() != 1) continue;
    if (!connected || space.mesh().Connected(*place, *space.Locate(*connected))) return p;
  }
  return std::nullopt;
}

/// A world with obstacles that keep apart, grown for a robot, and two places in it that are connected.
struct RobotGround {
  World world;
  double radius = 0;
  TautGround ground;
  Point from;
  Point to;
};

inline RobotGround MakeRobotGround(Rng& rng, double radius) {
  for (;;) {
    RandomScene scene = MakeRandomScene(rng, false);
    auto ground = PrepareRobotGround(scene.world, radius);
    if (!ground) continue;
    const auto from = RandomRobotPlace(rng, ground->space());
    if (!from) continue;
    const auto to = RandomRobotPlace(rng, ground->space(), from);
    if (!to || *to == *from) continue;
    return {std::move(scene.world), radius, *std::move(ground), *from, *to};
  }
}

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_RANDOM_ROBOT_GROUND_H_
