// Halls drawn in text with a manifold and a taut space, for tests of drives only.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_SKETCHED_HALL_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_SKETCHED_HALL_H_

#include <memory>
#include <utility>
#include <vector>

#include "tautline/planners/grid_manifold/drive.h"
#include "tautline/planners/grid_manifold/map_cells.h"

namespace tautline {

/// A rectangle with square pillars, tied at a base. Cells of 0.1 m.
struct Hall {
  Scene scene;
  std::unique_ptr<TautSpace> space;
  std::unique_ptr<GridManifold> manifold;

  Hall(Point size, std::vector<Box> pillars, Tether tether, Connectivity connectivity = Connectivity::kEight) {
    scene.world.outline = {{0, 0}, {size.x, 0}, size, {0, size.y}};
    for (const Box& box : pillars) {
      Obstacle pillar;
      pillar.polygon = PolygonWithHoles{{box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}, {}};
      scene.world.obstacles.push_back(pillar);
    }
    scene.tether = std::move(tether);
    Prepare(connectivity);
  }

  /// The floor of [Igarashi2010, Sec. 5] with round columns, whose cables need untangling.
  Hall(std::vector<Circle> columns, double length) {
    scene.world.outline = {{0, 0}, {5, 0}, {5, 3}, {0, 3}};
    scene.world.clearance = 0.17;
    for (const Circle& circle : columns) {
      Obstacle column;
      column.circle = circle;
      scene.world.obstacles.push_back(column);
    }
    scene.tether = Tether{.base = {0.25, 1.55}, .length = length, .laid = {}};
    Prepare(Connectivity::kEight);
  }

  void Prepare(Connectivity connectivity) {
    space = std::make_unique<TautSpace>(BuildFreeSpace(scene.world).value());
    CellGround ground = MakeCellGround(scene.world, {.resolution_m = 0.1}).value();
    const ManifoldOptions options{.base = *ground.CellAt(scene.tether->base),
                                  .length_m = LengthFromCell(ground, *scene.tether),
                                  .connectivity = connectivity};
    manifold = std::make_unique<GridManifold>(GridManifold::Build(std::move(ground), options));
  }

  DriveState Start(const DriveOptions& options = {}) const {
    return StartDrive(*manifold, *space, *scene.tether, options).value();
  }
  DriveResult Run(const std::vector<Point>& goals, const DriveOptions& options) const {
    return Drive(*manifold, Start(options), goals, options);
  }
  CellGround const& ground() const { return manifold->ground(); }
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_SKETCHED_HALL_H_
