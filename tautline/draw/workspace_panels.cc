#include "tautline/draw/workspace_panels.h"

#include <algorithm>

#include "tautline/draw/curve.h"
#include "tautline/draw/ground.h"
#include "tautline/draw/line_style.h"
#include "tautline/draw/sheet.h"
#include "tautline/draw/view.h"

namespace tautline {
namespace {

constexpr double kPadding = 8;  // Room for symbols on the rim of a map.
constexpr double kTallestMap = 520;

void DrawMove(SvgWriter& svg, const View& view, const Polyline& move) {
  const Polyline line = view.ToPixels(move);
  svg.Polyline(line, {.stroke = kWarningColour, .width = 1.4, .dashes = "4 2"});
  const Point last = line.back(), before = line[line.size() - 2];
  if (last != before) svg.ArrowHead(last, last - before, 8, {.fill = kWarningColour});
}

void DrawLayers(SvgWriter& svg, const std::vector<PanelLayer>& layers, const View& view, const Box& frame) {
  svg.OpenWindow("layers", frame);
  for (const PanelLayer& layer : layers) {
    std::vector<Ring> rings;
    for (const Ring& ring : layer.rings) rings.push_back(view.ToPixels(ring));
    svg.Polygon(rings, {.fill = layer.colour, .stroke = layer.colour, .width = 1.2, .opacity = 0.18});
  }
  svg.CloseWindow();
}

void DrawMap(SvgWriter& svg, const WorkspacePanel& panel, const View& view, const Box& frame) {
  DrawGround(svg, view, *panel.world, *panel.space, {.frame = frame});
  if (!panel.layers.empty()) DrawLayers(svg, panel.layers, view, frame);
  svg.OpenWindow("workspace", frame);
  if (!panel.boundary.empty()) {
    const Ring ring = view.ToPixels(panel.boundary);
    svg.Polygon({&ring, 1}, {.fill = kWorkspaceLine.colour, .opacity = 0.15});
    Polyline closed = ring;
    closed.push_back(ring[0]);
    svg.Polyline(closed, {.stroke = kWorkspaceLine.colour, .width = 2});
  }
  for (const TautPath& side : panel.sides) {
    svg.Polyline(view.ToPixels(side.points), {.stroke = kFaultLine.colour, .width = 1.8, .dashes = kFaultLine.dashes});
  }
  for (const Polyline& move : panel.moves) {
    if (move.size() > 1) DrawMove(svg, view, move);
  }
  for (const Point task : panel.tasks) {
    const Point at = view.ToPixels(task);
    svg.Rectangle({at - Point{3, 3}, at + Point{3, 3}}, {.fill = "#7b3fa0", .stroke = kHaloColour}, 1);
  }
  for (const Point anchor : panel.anchors) {
    svg.Circle(view.ToPixels(anchor), 4, {.fill = kInkColour, .stroke = kHaloColour, .width = 1.2});
  }
  svg.CloseWindow();
}

}  // namespace

std::string DrawWorkspacePanels(const PanelsContent& content, const std::vector<WorkspacePanel>& panels) {
  Box world;
  for (const WorkspacePanel& panel : panels) {
    world.Add(panel.space->box.low);
    world.Add(panel.space->box.high);
  }
  world = WithoutFlatSides(world);
  const double aspect = world.size().x / world.size().y;
  const std::size_t most = aspect > 2.2 ? 2 : aspect > 1.3 ? 3 : 4;
  const std::size_t columns = std::clamp<std::size_t>(panels.size(), 2, most);
  const auto shares = static_cast<double>(columns);
  const double width = SheetFrameWidth(1, shares, columns);
  SheetContent sheet{.title = content.title, .notes = content.notes, .rows = {}};
  for (const WorkspacePanel& panel : panels) {
    if (sheet.rows.empty() || sheet.rows.back().panels.size() == columns) {
      sheet.rows.push_back({.panels = {},
                            .height = std::min(kTallestMap, (width - 2 * kPadding) / aspect + 2 * kPadding),
                            .shares = shares});
    }
    const auto draw = [&panel, &world](SvgWriter& svg, const Box& frame) {
      const View view(world, {frame.low + Point{kPadding, kPadding}, frame.high - Point{kPadding, kPadding}});
      DrawMap(svg, panel, view, frame);
    };
    sheet.rows.back().panels.push_back({.title = panel.title, .notes = panel.notes, .draw = draw});
  }
  return DrawSheet(sheet);
}

}  // namespace tautline
