#include "tautline/draw/draw_field.h"

#include <algorithm>
#include <vector>

#include "tautline/draw/figure.h"
#include "tautline/draw/heading_arrows.h"
#include "tautline/draw/length_text.h"
#include "tautline/draw/line_style.h"

namespace tautline {
namespace {

struct Arrows {
  std::vector<SvgCurve> first, others;
};

Arrows ArrowsOf(const FieldPicture& picture, const View& view) {
  const ArrowLattice lattice(picture.grid.resolution, view);
  Arrows arrows;
  const FieldSample* before = nullptr;
  for (const FieldSample& sample : picture.samples) {
    const bool is_first = before == nullptr || before->row != sample.row || before->column != sample.column;
    before = &sample;
    if (!sample.heading_rad || !lattice.Has(sample.column, sample.row)) continue;
    AppendArrow(view.ToPixels(sample.at), *sample.heading_rad, lattice.length_px,
                is_first ? arrows.first : arrows.others);
  }
  return arrows;
}

std::string Title(const FieldPicture& picture, int decimals) {
  if (picture.from_base.status == PlanStatus::kInfeasible) return "No field: the robot cannot get to the goal";
  return "Where to drive next from everywhere, with " + LengthText(picture.from_base.limit, decimals) + " of tether";
}

std::vector<LegendEntry> FieldLegend(const FieldPicture& picture, int decimals) {
  std::vector<LegendEntry> legend;
  if (picture.samples.empty()) return legend;
  LineStyle swatch = kHeadingLine;
  swatch.arrows = true;
  swatch.width = 1.4;
  const int enough = std::min(DecimalsToTellApart(picture.grid.resolution, 0, decimals), decimals + 3);
  legend.push_back(
      {swatch,
       "the robot's next heading",
       {"with its tether in the shortest class", "planned every " + LengthText(picture.grid.resolution, enough),
        "none where the tether does not reach"}});
  const auto twin = std::adjacent_find(
      picture.samples.begin(), picture.samples.end(),
      [](const FieldSample& a, const FieldSample& b) { return a.row == b.row && a.column == b.column; });
  if (twin != picture.samples.end()) {
    LineStyle other = kOtherHeadingLine;
    other.arrows = true;
    legend.push_back({other, "with the tether in another class"});
  }
  return legend;
}

}  // namespace

std::string DrawField(const Scene& scene, const FreeSpace& space, const FieldPicture& picture) {
  const int decimals = LengthDecimals(space);
  FigureContent content{.title = Title(picture, decimals), .legend = FieldLegend(picture, decimals)};
  if (!picture.from_base.explanation.empty()) content.notes.push_back(picture.from_base.explanation);
  if (scene.tether) content.shown.push_back(scene.tether->base);
  if (scene.goal) content.shown.push_back(*scene.goal);
  Figure figure(scene, space, content);
  const Arrows arrows = ArrowsOf(picture, figure.view());
  figure.Shape("other-headings", arrows.others, {.stroke = kOtherHeadingLine.colour, .width = kOtherHeadingLine.width});
  figure.Shape("headings", arrows.first, {.stroke = kHeadingLine.colour, .width = kHeadingLine.width});
  if (scene.tether) figure.Mark(Marker::kBase, scene.tether->base, "base");
  if (scene.goal) figure.Mark(Marker::kGoal, *scene.goal, "goal");
  return figure.Finish();
}

}  // namespace tautline
