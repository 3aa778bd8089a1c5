#include "tautline/draw/workspace_panels.h"

#include <algorithm>

#include "tautline/draw/curve.h"
#include "tautline/draw/ground.h"
#include "tautline/draw/line_style.h"
#include "tautline/draw/text_metrics.h"
#include "tautline/draw/view.h"

namespace tautline {
namespace {

constexpr double kPageWidth = 1000;
constexpr double kMargin = 20;
constexpr double kGap = 16;
constexpr double kPadding = 8;  // Room for symbols on the rim of a map.
constexpr double kTitleSize = 17;
constexpr double kTitleLine = 22;
constexpr double kNoteSize = 13;
constexpr double kNoteLine = 17.5;
constexpr double kPanelTitleSize = 12.5;
constexpr double kPanelNoteSize = 11;
constexpr double kPanelLine = 15;
constexpr double kTallestMap = 520;

/// Where everything goes.
struct Layout {
  std::size_t columns = 1;
  Point cell;  ///< Width and height of a panel with its texts.
  double map_height = 0;
  double text_height = 0;  ///< Above each map.
  double top = 0;          ///< Of the first row.
  std::vector<std::string> title, notes;
};

Layout LayOut(const PanelsContent& content, const std::vector<WorkspacePanel>& panels, const Box& world) {
  Layout layout;
  const double aspect = world.size().x / world.size().y;
  const std::size_t most = aspect > 2.2 ? 2 : aspect > 1.3 ? 3 : 4;
  layout.columns = std::clamp<std::size_t>(panels.size(), 2, most);
  const auto columns = static_cast<double>(layout.columns);
  layout.cell.x = (kPageWidth - 2 * kMargin - (columns - 1) * kGap) / columns;
  layout.map_height = std::min(kTallestMap, (layout.cell.x - 2 * kPadding) / aspect + 2 * kPadding);
  std::size_t lines = 0;
  for (const WorkspacePanel& panel : panels) lines = std::max(lines, panel.notes.size());
  layout.text_height = kPanelLine * static_cast<double>(lines + 1) + 5;
  layout.cell.y = layout.text_height + layout.map_height;
  const double width = kPageWidth - 2 * kMargin;
  layout.title = Wrap(content.title, {.size = kTitleSize, .width = width, .max_lines = 3, .bold = true});
  for (const std::string& note : content.notes) {
    for (std::string& line : Wrap(note, {.size = kNoteSize, .width = width, .max_lines = 3})) {
      layout.notes.push_back(std::move(line));
    }
  }
  layout.top = kMargin + kTitleLine * static_cast<double>(layout.title.size()) +
               kNoteLine * static_cast<double>(layout.notes.size()) + 10;
  return layout;
}

void DrawHead(SvgWriter& svg, const Layout& layout) {
  svg.OpenGroup("title");
  double y = kMargin;
  for (const std::string& line : layout.title) {
    svg.Text({.at = {kMargin, y + 15}, .text = line, .size = kTitleSize, .bold = true});
    y += kTitleLine;
  }
  for (const std::string& line : layout.notes) {
    svg.Text({.at = {kMargin, y + 12}, .text = line, .size = kNoteSize, .fill = "#333333"});
    y += kNoteLine;
  }
  svg.CloseGroup();
}

/// The texts above a map whose upper left corner of the cell is `at`.
void DrawTexts(SvgWriter& svg, const WorkspacePanel& panel, Point at, double width) {
  svg.Text({.at = at + Point{0, 12},
            .text = Ellipsize(panel.title, kPanelTitleSize, width),
            .size = kPanelTitleSize,
            .bold = true});
  for (std::size_t i = 0; i < panel.notes.size(); ++i) {
    svg.Text({.at = at + Point{0, 12 + kPanelLine * static_cast<double>(i + 1)},
              .text = Ellipsize(panel.notes[i], kPanelNoteSize, width),
              .size = kPanelNoteSize,
              .fill = kSecondaryInkColour});
  }
}

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
  const Layout layout = LayOut(content, panels, world);
  const std::size_t row_count = (panels.size() + layout.columns - 1) / layout.columns;
  const auto rows = static_cast<double>(row_count);
  SvgWriter svg({.width = kPageWidth,
                 .height = layout.top + rows * (layout.cell.y + kGap) - kGap + kMargin,
                 .decimals = 1,
                 .title = content.title});
  svg.DefineHatch(kClearanceColour, kClearanceLineColour);
  DrawHead(svg, layout);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const std::size_t in_row = i % layout.columns, row_index = i / layout.columns;
    const auto column = static_cast<double>(in_row), row = static_cast<double>(row_index);
    const Point at{kMargin + column * (layout.cell.x + kGap), layout.top + row * (layout.cell.y + kGap)};
    const Box frame{at + Point{0, layout.text_height}, at + layout.cell};
    const View view(world, {frame.low + Point{kPadding, kPadding}, frame.high - Point{kPadding, kPadding}});
    svg.OpenGroup("panel");
    DrawTexts(svg, panels[i], at, layout.cell.x);
    DrawMap(svg, panels[i], view, frame);
    svg.CloseGroup();
  }
  return svg.Finish();
}

}  // namespace tautline
