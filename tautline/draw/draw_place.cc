#include "tautline/draw/draw_place.h"

#include <utility>

#include "tautline/draw/length_text.h"
#include "tautline/draw/workspace_layers.h"

namespace tautline {
namespace {

/// The best placement so far.
const LineStyle kBestLine = {.colour = "#00684c", .width = 2};
/// Where a job started: faint, since many lie behind the answer.
constexpr char kStartColour[] = "#b07bb0";
constexpr double kStartRadius = 3.6;
constexpr double kStartOpacity = 0.5;

struct Case {
  const Scene& scene;
  const PlacementGround& ground;
  const PlaceResult& result;
  int decimals;

  bool by_cable() const { return ground.options().objective == PlaceObjective::kCable; }
};

std::string Title(const Case& c) {
  if (c.result.status == PlaceStatus::kInfeasible) return "No place for the winches: a task cannot be held";
  if (c.result.status != PlaceStatus::kSolved) return "No place for the winches was found";
  const Placement& placement = *c.result.placement;
  const std::string winches = std::to_string(placement.anchors.size()) + " winches ";
  if (c.by_cable()) {
    return winches + "hold all tasks with " + LengthText(placement.worth.value, c.decimals) + " of cable";
  }
  return winches + "can move the robot in " + AreaText(placement.worth.value) +
         (c.result.details.futures ? ", expected" : "");
}

std::vector<LegendEntry> PlaceLegend(const Case& c) {
  std::vector<LegendEntry> legend;
  if (c.result.placement) {
    legend.push_back({GroundSwatch{.fill = kWorkspaceFill, .edge = kWorkspaceLine.colour},
                      "workspace " + AreaText(c.result.placement->boundary.area)});
    LegendEntry winches{Marker::kWinch, "winch, and the cable that it needs"};
    const std::vector<double>& lengths = c.result.details.longest_cables;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      winches.details.push_back(std::to_string(i + 1) + ": " + LengthText(lengths[i], c.decimals));
    }
    legend.push_back(std::move(winches));
  }
  if (!c.scene.tasks.empty()) legend.push_back({Marker::kTask, "task"});
  if (!c.result.starts.empty()) {
    legend.push_back({GroundSwatch{.fill = kStartColour, .edge = kFreeColour}, "dots: where searches started"});
  }
  return legend;
}

/// How the best improved, as a staircase up to the last evaluation.
PlotContent HistoryPlot(const Case& c) {
  Polyline stairs;
  std::vector<Point> dots;
  for (const PlaceRecord& record : c.result.history) {
    const auto x = static_cast<double>(record.evaluations);
    if (!stairs.empty()) stairs.push_back({x, stairs.back().y});
    stairs.push_back({x, record.best});
    dots.push_back(stairs.back());
  }
  stairs.push_back({static_cast<double>(c.result.evaluations), stairs.back().y});
  const bool expected = c.result.details.futures.has_value();
  PlotContent plot{.title = "The best so far",
                   .x_label = "placements looked at",
                   .y_label = c.by_cable() ? "cable (m)"
                              : expected   ? "expected area (m²)"
                                           : "area (m²)",
                   .series = {}};
  plot.series.push_back({"", kBestLine, {std::move(stairs)}, std::move(dots)});
  return plot;
}

void DrawStarts(Figure& figure, const Case& c) {
  for (const std::vector<double>& start : c.result.starts) {
    for (const double position : start) {
      const Point at = figure.view().ToPixels(c.ground.outline().At(position));
      const Point left = at - Point{kStartRadius, 0}, right = at + Point{kStartRadius, 0};
      const SvgCurve dot{.start = left, .steps = {{right, kStartRadius}, {left, kStartRadius}}, .closed = true};
      figure.Shape("start", std::span<const SvgCurve>(&dot, 1), {.fill = kStartColour, .opacity = kStartOpacity});
    }
  }
}

}  // namespace

std::string DrawPlace(const Scene& scene, const PlacementGround& ground, const PlaceResult& result) {
  const FreeSpace& space = ground.ground().space().free_space();
  const Case c{scene, ground, result, LengthDecimals(space)};
  FigureContent content{.title = Title(c), .legend = PlaceLegend(c), .shown = scene.tasks};
  if (!result.explanation.empty()) content.notes.push_back(Sentence(result.explanation));
  if (!result.history.empty()) content.plots.push_back(HistoryPlot(c));
  Figure figure(scene, space, content);
  DrawStarts(figure, c);
  if (result.placement) {
    DrawWorkspaceArea(figure, result.placement->boundary.ring);
    MarkAnchors(figure, BasesOf(result.placement->anchors));
  }
  MarkTasks(figure, scene);
  return figure.Finish();
}

}  // namespace tautline
