#include "tautline/draw/draw_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tautline/draw/figure.h"
#include "tautline/draw/length_text.h"
#include "tautline/draw/line_style.h"

namespace tautline {
namespace {

/// Between arrows that can be told apart, pixels.
constexpr double kLeastSpacing = 11;
constexpr double kLongestArrow = 16;
constexpr double kArrowShare = 0.78;  ///< Of the spacing.

const LineStyle kHeadingLine = {.colour = "#0b4a8f", .width = 1};
const LineStyle kOtherHeadingLine = {.colour = "#9a9a9a", .width = 0.8};

/// How often a point of the grid has an arrow: every so many columns and rows.
int StrideOf(const FieldGrid& grid, const View& view) {
  const double spacing = grid.resolution * view.pixels_per_metre();
  return std::max(1, static_cast<int>(std::ceil(kLeastSpacing / std::max(spacing, 1e-9) - 1e-9)));
}

/// An open arrow of a length in pixels about a point.
void AppendArrow(Point middle, double heading, double length, std::vector<SvgCurve>& curves) {
  constexpr double kBarbShare = 0.38;
  constexpr double kBarbAngle = 0.85 * std::numbers::pi;
  const auto towards = [](double angle) { return Point{std::cos(angle), -std::sin(angle)}; };  // y points down.
  const Point tip = middle + 0.5 * length * towards(heading), tail = middle - 0.5 * length * towards(heading);
  curves.push_back({.start = tail, .steps = {{.to = tip}}});
  const double barb = kBarbShare * length;
  curves.push_back({.start = tip + barb * towards(heading + kBarbAngle),
                    .steps = {{.to = tip}, {.to = tip + barb * towards(heading - kBarbAngle)}}});
}

struct Arrows {
  std::vector<SvgCurve> first, others;
};

Arrows ArrowsOf(const FieldPicture& picture, const View& view) {
  const int stride = StrideOf(picture.grid, view);
  const double spacing = stride * picture.grid.resolution * view.pixels_per_metre();
  const double length = std::min(kArrowShare * spacing, kLongestArrow);
  Arrows arrows;
  const FieldSample* before = nullptr;
  for (const FieldSample& sample : picture.samples) {
    const bool is_first = before == nullptr || before->row != sample.row || before->column != sample.column;
    before = &sample;
    if (!sample.heading_rad || sample.row % stride != stride / 2 || sample.column % stride != stride / 2) continue;
    AppendArrow(view.ToPixels(sample.at), *sample.heading_rad, length, is_first ? arrows.first : arrows.others);
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
