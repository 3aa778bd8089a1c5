#include "tautline/draw/draw_sheets.h"

#include <algorithm>
#include <array>
#include <utility>

#include "tautline/draw/workspace_panels.h"

namespace tautline {
namespace {

/// The colours of [Okabe2008], and darker ones of the same.
constexpr std::array<const char*, kMostSheetsShown> kSheetColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                                     "#b8860b", "#56b4e9", "#004d7a", "#8f3f00",
                                                                     "#00684c", "#8a4a70", "#7a5a00", "#2f7fae"};

PanelLayer LayerOf(const ManifoldSheet& sheet, std::size_t rank) {
  PanelLayer layer{.colour = kSheetColours[rank], .rings = {}};
  for (const PolygonWithHoles& polygon : sheet.boundary) {
    layer.rings.push_back(polygon.outer);
    layer.rings.insert(layer.rings.end(), polygon.holes.begin(), polygon.holes.end());
  }
  return layer;
}

std::string WordText(const ManifoldSheet& sheet, const std::vector<std::string>& names) {
  const std::string word = ToString(sheet.word, names);
  return word.empty() ? "the empty word" : word;
}

}  // namespace

std::string DrawSheets(const Scene& scene, const std::vector<ManifoldSheet>& sheets,
                       const std::vector<std::string>& names) {
  const auto space = BuildFreeSpace(scene.world);
  if (!space) return "";
  const std::size_t shown = std::min(kMostSheetsShown, sheets.size());
  PanelsContent content{.title = std::to_string(sheets.size()) +
                                 (sheets.size() == 1 ? " sheet: the cells" : " sheets: the cells") +
                                 " that the tether reaches, by its word"};
  if (shown < sheets.size()) content.notes.push_back("Shown are the largest " + std::to_string(shown) + ".");
  content.notes.emplace_back("First all on top of each other, then each by itself. The dot is the base.");
  std::vector<WorkspacePanel> panels;
  const auto add = [&](std::string title, std::string note) -> WorkspacePanel& {
    return panels.emplace_back(WorkspacePanel{.world = &scene.world,
                                              .space = &*space,
                                              .title = std::move(title),
                                              .notes = {std::move(note)},
                                              .anchors = {scene.tether->base},
                                              .boundary = {}});
  };
  WorkspacePanel& all = add("overlapped", std::to_string(shown) + " layers");
  for (std::size_t i = 0; i < shown; ++i) all.layers.push_back(LayerOf(sheets[i], i));
  for (std::size_t i = 0; i < shown; ++i) {
    add(std::to_string(i + 1) + ": " + WordText(sheets[i], names), std::to_string(sheets[i].vertices) + " vertices")
        .layers.push_back(LayerOf(sheets[i], i));
  }
  return DrawWorkspacePanels(content, panels);
}

}  // namespace tautline
