#include "tautline/draw/draw_comparison.h"

#include <algorithm>
#include <array>

#include "tautline/draw/ground.h"
#include "tautline/draw/line_style.h"
#include "tautline/draw/sheet.h"
#include "tautline/draw/view.h"

namespace tautline {
namespace {

constexpr std::size_t kColumns = 4;
constexpr double kPadding = 6;

struct MethodStyle {
  const char* method;
  const char* text;
  LineStyle style;
};

/// The paper's colours for its three; ours thicker.
const std::array<MethodStyle, 5> kStyles = {
    {{"dijkstra", "Homotopic Dijkstra", {.colour = "#00803c", .width = 1.6, .dashes = "6 3"}},
     {"voronoi", "Homotopic Voronoi", {.colour = "#2a5bd7", .width = 1.6, .dashes = "2 2"}},
     {"learned", "deep Q-network", {.colour = "#d02020", .width = 1.8}},
     {"general", "policy for all maps", {.colour = "#a050b0", .width = 1.8}},
     {"search", "search", {.colour = "#d08000", .width = 2.4}}}};

const MethodStyle* StyleOf(const std::string& method) {
  const auto found =
      std::find_if(kStyles.begin(), kStyles.end(), [&](const auto& style) { return style.method == method; });
  return found == kStyles.end() ? nullptr : &*found;
}

void DrawPanel(SvgWriter& svg, const ComparisonPanel& panel, const Box& frame) {
  Box world = panel.space.box;
  const View view(WithoutFlatSides(world),
                  {frame.low + Point{kPadding, kPadding}, frame.high - Point{kPadding, kPadding}});
  DrawGround(svg, view, panel.scene->world, panel.space, {.frame = frame});
  svg.OpenWindow("paths", frame);
  if (panel.scene->tether->laid && panel.scene->tether->laid->size() > 1) {
    svg.Polyline(view.ToPixels(*panel.scene->tether->laid), {.stroke = kInkColour, .width = 1.2, .dashes = "4 2"});
  }
  for (const MethodPath& path : panel.paths) {
    const MethodStyle* const style = StyleOf(path.method);
    if (style == nullptr || path.path.size() < 2) continue;
    svg.Polyline(view.ToPixels(path.path),
                 {.stroke = style->style.colour, .width = style->style.width, .dashes = style->style.dashes});
  }
  svg.Circle(view.ToPixels(panel.scene->tether->base), 4, {.fill = kInkColour, .stroke = kHaloColour, .width = 1.2});
  const Point goal = view.ToPixels(*panel.scene->goal);
  svg.Rectangle({goal - Point{4, 4}, goal + Point{4, 4}}, {.fill = "#d02020", .stroke = kHaloColour}, 1);
  svg.CloseWindow();
}

}  // namespace

std::string DrawComparison(const std::string& title, const std::vector<ComparisonPanel>& panels) {
  SheetContent sheet{.title = title,
                     .notes = {"Dot: the base. Square: the goal. Dashed black: the cable as it lies at the start."},
                     .rows = {}};
  const double width = SheetFrameWidth(1, kColumns, kColumns);
  for (const ComparisonPanel& panel : panels) {
    if (sheet.rows.empty() || sheet.rows.back().panels.size() == kColumns) {
      sheet.rows.push_back({.panels = {}, .height = width, .shares = kColumns});
    }
    const auto draw = [&panel](SvgWriter& svg, const Box& frame) { DrawPanel(svg, panel, frame); };
    sheet.rows.back().panels.push_back({.title = panel.title, .notes = {}, .draw = draw});
  }
  for (const MethodStyle& style : kStyles) {
    const bool shown = std::any_of(panels.begin(), panels.end(), [&](const ComparisonPanel& panel) {
      return std::any_of(panel.paths.begin(), panel.paths.end(),
                         [&](const MethodPath& path) { return path.method == style.method; });
    });
    if (shown) sheet.legend.push_back({style.style, style.text});
  }
  return DrawSheet(sheet);
}

}  // namespace tautline
