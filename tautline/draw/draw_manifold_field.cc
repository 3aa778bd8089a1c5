#include "tautline/draw/draw_manifold_field.h"

#include <numbers>
#include <vector>

#include "tautline/draw/figure.h"
#include "tautline/draw/heading_arrows.h"
#include "tautline/draw/length_text.h"

namespace tautline {
namespace {

struct Arrows {
  std::vector<SvgCurve> nearest, others;
};

Arrows ArrowsOf(const GridManifold& manifold, const ManifoldGoalField& field, const View& view) {
  const CellGround& ground = manifold.ground();
  const ArrowLattice lattice(ground.cell_m(), view);
  Arrows arrows;
  for (int row = lattice.stride / 2; row < ground.rows(); row += lattice.stride) {
    for (int column = lattice.stride / 2; column < ground.columns(); column += lattice.stride) {
      bool is_nearest = true;
      for (const ManifoldVertex v : manifold.VerticesAt({column, row})) {
        if (const auto d = field.Direction(v)) {
          AppendArrow(view.ToPixels(ground.CentreOf({column, row})), *d * std::numbers::pi / 4 + ground.grid().yaw_rad,
                      lattice.length_px, is_nearest ? arrows.nearest : arrows.others);
        }
        is_nearest = false;
      }
    }
  }
  return arrows;
}

FigureContent ContentOf(const Scene& scene, const GridManifold& manifold, const ManifoldGoalField& field) {
  FigureContent content;
  content.shown = {scene.tether->base, *scene.goal};
  if (field.goals() == 0) {
    content.title = "No field: the tether does not reach the goal";
    return content;
  }
  const double from_base = CellsOf(field.distance(manifold.base_vertex())) * manifold.ground().cell_m();
  content.title = "Where to drive next from everywhere: the goal is " + LengthText(from_base, 2) + " from the base";
  LineStyle nearest = kHeadingLine, others = kOtherHeadingLine;
  nearest.arrows = others.arrows = true;
  nearest.width = 1.4;
  content.legend = {{nearest, "the next heading, with the tether in its shortest class"},
                    {others, "with the tether in another class"},
                    {kPathLine, "the way from the base"}};
  return content;
}

}  // namespace

std::string DrawManifoldField(const Scene& scene, const GridManifold& manifold, const ManifoldGoalField& field) {
  const auto space = BuildFreeSpace(scene.world);
  if (!space) return "";
  Figure figure(scene, *space, ContentOf(scene, manifold, field));
  const Arrows arrows = ArrowsOf(manifold, field, figure.view());
  figure.Shape("other-headings", arrows.others, {.stroke = kOtherHeadingLine.colour, .width = kOtherHeadingLine.width});
  figure.Shape("headings", arrows.nearest, {.stroke = kHeadingLine.colour, .width = kHeadingLine.width});
  Polyline way;
  for (const ManifoldVertex v : field.WayFrom(manifold.base_vertex())) {
    way.push_back(manifold.ground().CentreOf(manifold.CellOf(v)));
  }
  if (way.size() > 1) figure.Line("robot-path", way, kPathLine);
  figure.Mark(Marker::kBase, scene.tether->base, "base");
  figure.Mark(Marker::kGoal, *scene.goal, "goal");
  return figure.Finish();
}

}  // namespace tautline
