// Random workspaces for tests, in the random scenes of the engine.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_RANDOM_WORKSPACE_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_RANDOM_WORKSPACE_H_

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "tautline/homotopy/classes.h"
#include "tautline/homotopy/random_scene.h"
#include "tautline/planners/cable_workspace/region.h"

namespace tautline {

/// A workspace with all that it refers to.
struct RandomWorkspace {
  RandomScene scene;
  CableGround ground;
  Anchors anchors;
  WorkspaceBoundary boundary;
  std::unique_ptr<const WorkspaceRegion> region = nullptr;
};

namespace random_workspace {

/// Anchors at corners and middles of edges of the outer ring, in order.
inline std::vector<Point> RandomAnchorPoints(Rng& rng, const Ring& ring) {
  const auto edges = static_cast<int>(ring.size());
  std::vector<int> halves;
  for (int i = rng.UniformInt(3, 5); i > 0; --i) halves.push_back(rng.UniformInt(0, 2 * edges - 1));
  std::sort(halves.begin(), halves.end());
  halves.erase(std::unique(halves.begin(), halves.end()), halves.end());
  std::vector<Point> points;
  for (const int half : halves) {
    const auto edge = static_cast<std::size_t>(half / 2);
    points.push_back(Lerp(ring[edge], ring[(edge + 1) % ring.size()], half % 2 == 0 ? 0 : 0.5));
  }
  return points;
}

/// From the robot to each anchor in one of the shortest classes.
inline std::optional<std::vector<Polyline>> RandomLaid(Rng& rng, const TautSpace& space, const Anchors& anchors,
                                                       Point robot) {
  std::vector<Polyline> laid;
  for (const Socket& anchor : anchors) {
    const auto list = FindClasses(space, robot, anchor.exit.point, {.max_length = {}, .max_count = 2});
    if (list.classes.empty()) return std::nullopt;
    const bool second = list.classes.size() > 1 && rng.UniformInt(0, 3) == 0;
    laid.push_back(list.classes[second ? 1 : 0].points);
    if (laid.back().size() == 1) laid.back().push_back(laid.back()[0]);
  }
  return laid;
}

}  // namespace random_workspace

/// A valid workspace in a scene of the family; one scene in three has a clearance, where it stands apart from walls.
inline RandomWorkspace MakeRandomWorkspace(Rng& rng, bool lattice) {
  for (;;) {
    RandomScene scene = MakeRandomScene(rng, lattice);
    if (rng.UniformInt(0, 2) == 0) scene.world.clearance = 0.25;
    auto ground = CableGround::Prepare(scene.world);
    if (!ground) continue;
    const Ring& outer = ground->ungrown_space().components[0].outer.points;
    auto anchors = PlaceAnchors(*ground, random_workspace::RandomAnchorPoints(rng, outer));
    const Point robot = RandomFreePoint(rng, scene);
    if (!anchors || anchors->size() < 3 || !ground->space().Locate(robot)) continue;
    const auto laid = random_workspace::RandomLaid(rng, ground->space(), *anchors, robot);
    if (!laid) continue;
    auto boundary = BoundaryOfCables(*ground, *anchors, *laid);
    if (!boundary) continue;
    RandomWorkspace made{std::move(scene), *std::move(ground), *std::move(anchors), *std::move(boundary)};
    return made;
  }
}

/// The region refers to the rest, which must stay where it is from now on.
inline const WorkspaceRegion& RegionOf(RandomWorkspace& workspace) {
  workspace.region = std::make_unique<const WorkspaceRegion>(workspace.ground, workspace.anchors, workspace.boundary);
  return *workspace.region;
}

/// A place in the workspace: inside, on its boundary or at a corner of it.
inline Point RandomPlaceInside(Rng& rng, const WorkspaceRegion& region) {
  const Ring& ring = region.boundary().ring;
  for (;;) {
    const auto i = static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(ring.size()) - 1));
    Point p = RandomPoint(rng, BoundingBox(ring));
    if (rng.UniformInt(0, 5) == 0) p = Lerp(ring[i], ring[(i + 1) % ring.size()], 0.5 * rng.UniformInt(0, 2));
    if (!region.WaysTo(p).empty()) return p;
  }
}

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_RANDOM_WORKSPACE_H_
