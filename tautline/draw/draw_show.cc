#include "tautline/draw/draw_show.h"

#include <algorithm>

#include "tautline/draw/length_text.h"
#include "tautline/draw/tether_layers.h"

namespace tautline {
namespace {

constexpr std::size_t kMostPieces = 5;       // With a tint and a line in the legend.
constexpr std::size_t kMostMerges = 6;       // Listed in the legend.
constexpr std::size_t kMostSnapMarks = 200;  // Drawn.

std::string Counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

double FreeArea(const FreeSpace& space) {
  double area = 0;
  for (const FreeComponent& component : space.components) area += component.area;
  return area;
}

std::string Title(const FreeSpace& space) {
  const std::string pieces = space.components.size() == 1
                                 ? "in one piece"
                                 : "in " + Counted(space.components.size(), "piece", "separate pieces");
  const std::string islands =
      space.islands.empty() ? "no obstacles" : Counted(space.islands.size(), "obstacle", "obstacles");
  return "Free space " + AreaText(FreeArea(space)) + " " + pieces + ", " + islands;
}

std::vector<std::string> Notes(const World& world) {
  if (!world.map) return {};
  const MapSource& map = *world.map;
  std::string text = "Map " + map.path + " (" + map.kind + ")";
  if (map.columns > 0) {
    text += ", " + std::to_string(map.columns) + " × " + std::to_string(map.rows) + " cells of " +
            CompactText(map.resolution, 6) + " m";
  }
  if (map.unknown_cells > 0) text += ", " + Counted(map.unknown_cells, "cell", "cells") + " unknown";
  return {text};
}

std::vector<std::string> Tints(const FreeSpace& space) {
  std::vector<std::string> tints;
  if (space.components.size() < 2) return tints;
  for (std::size_t i = 0; i < space.components.size(); ++i) {
    tints.push_back(ComponentTint(static_cast<int>(std::min(i, kMostPieces))));
  }
  return tints;
}

std::string PieceName(std::size_t i) { return std::string(1, static_cast<char>('A' + i)); }

void AppendPieces(const FreeSpace& space, std::vector<LegendEntry>& legend) {
  const std::size_t count = space.components.size();
  if (count < 2) return;
  const std::size_t listed = count <= kMostPieces + 1 ? count : kMostPieces;
  for (std::size_t i = 0; i < listed; ++i) {
    legend.push_back({GroundSwatch{.fill = ComponentTint(static_cast<int>(std::min(i, kMostPieces)))},
                      "piece " + PieceName(i) + ", " + AreaText(space.components[i].area)});
  }
  if (listed == count) return;
  double rest = 0;
  for (std::size_t i = listed; i < count; ++i) rest += space.components[i].area;
  legend.push_back({GroundSwatch{.fill = ComponentTint(kMostPieces)},
                    std::to_string(count - listed) + " smaller pieces, " + AreaText(rest)});
}

std::string Joined(const std::vector<std::string>& names) {
  constexpr std::size_t kMostNames = 8;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMostNames); ++i) text += (i > 0 ? " + " : "") + names[i];
  if (names.size() > kMostNames) text += " + " + std::to_string(names.size() - kMostNames) + " more";
  return text;
}

void AppendMerges(const FreeSpace& space, std::vector<LegendEntry>& legend) {
  if (space.merges.empty()) return;
  LegendEntry entry{std::monostate(), "Merged"};
  for (std::size_t i = 0; i < std::min(space.merges.size(), kMostMerges); ++i) {
    const Merge& merge = space.merges[i];
    entry.details.push_back((merge.with_wall ? "wall + " : "") + Joined(merge.members));
  }
  if (space.merges.size() > kMostMerges) {
    entry.details.push_back("and " + std::to_string(space.merges.size() - kMostMerges) + " more");
  }
  legend.push_back(std::move(entry));
}

void AppendSnaps(const FreeSpace& space, std::vector<LegendEntry>& legend) {
  if (space.snaps.empty()) return;
  legend.push_back({Marker::kSnap,
                    Counted(space.snaps.size(), "boundary vertex", "boundary vertices") + " joined to a neighbour",
                    {"nearer than " + RoundLengthText(space.snap)}});
}

void AppendTether(const Scene& scene, const FreeSpace& space, std::vector<LegendEntry>& legend) {
  if (!scene.tether) return;
  const int decimals = LengthDecimals(space);
  AppendLaidEntry(scene, decimals, legend);
  legend.push_back({Marker::kBase, "base, tether " + LengthText(scene.tether->length, decimals)});
}

std::vector<LegendEntry> ShowLegend(const Scene& scene, const FreeSpace& space) {
  std::vector<LegendEntry> legend;
  AppendTether(scene, space, legend);
  AppendPieces(space, legend);
  AppendSnaps(space, legend);
  AppendMerges(space, legend);
  return legend;
}

/// Letters on the tinted pieces.
void LabelPieces(Figure& figure, const FreeSpace& space) {
  if (space.components.size() < 2) return;
  for (std::size_t i = 0; i < std::min(space.components.size(), kMostPieces); ++i) {
    const FreeComponent& component = space.components[i];
    PolygonWithHoles polygon{component.outer.points, {}};
    for (const BoundaryRing& hole : component.holes) polygon.holes.push_back(hole.points);
    if (polygon.outer.size() < 3) continue;
    const Point size = BoundingBox(polygon.outer).size();
    figure.LabelPoint(InteriorPoint(polygon), PieceName(i), std::min(size.x, size.y));
  }
}

}  // namespace

std::string DrawShow(const Scene& scene, const FreeSpace& space) {
  Figure figure(scene, space,
                {.title = Title(space),
                 .notes = Notes(scene.world),
                 .legend = ShowLegend(scene, space),
                 .tints = Tints(space),
                 .shown = TetherPoints(scene),
                 .outline_obstacles = true});
  DrawLaid(figure, scene);
  for (std::size_t i = 0; i < std::min(space.snaps.size(), kMostSnapMarks); ++i) {
    figure.Mark(Marker::kSnap, space.snaps[i].to);
  }
  LabelPieces(figure, space);
  MarkTether(figure, scene);
  return figure.Finish();
}

}  // namespace tautline
