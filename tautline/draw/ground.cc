#include "tautline/draw/ground.h"

#include "tautline/draw/length_text.h"

namespace tautline {
namespace {

Ring Corners(const Box& box) { return {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}; }

void AppendRings(const View& view, const PolygonWithHoles& polygon, std::vector<Ring>& rings) {
  rings.push_back(view.ToPixels(polygon.outer));
  for (const Ring& hole : polygon.holes) rings.push_back(view.ToPixels(hole));
}

void DrawObstacle(SvgWriter& svg, const View& view, const Obstacle& obstacle, const SvgStyle& style) {
  if (obstacle.circle) {
    svg.Circle(view.ToPixels(obstacle.circle->centre), obstacle.circle->radius * view.pixels_per_metre(), style);
  }
  if (obstacle.polygon) {
    std::vector<Ring> rings;
    AppendRings(view, *obstacle.polygon, rings);
    svg.Polygon(rings, style);
  }
}

/// The blocked ground before it grew. Obstacles of a map do not overlap and make one shape; listed
/// ones may overlap and are drawn one by one.
void DrawOriginals(SvgWriter& svg, const View& view, const World& world, const GroundOptions& options) {
  const SvgStyle style = {.fill = kBlockedColour, .stroke = kBoundaryColour, .width = 0.7};
  std::vector<Ring> rings = {Corners(options.frame), view.ToPixels(world.outline)};
  if (!world.outline.empty()) svg.Polygon(rings, style);
  rings.clear();
  for (const Obstacle& obstacle : world.obstacles) {
    if (obstacle.from_map && obstacle.polygon) {
      AppendRings(view, *obstacle.polygon, rings);
    } else {
      DrawObstacle(svg, view, obstacle, style);
    }
  }
  svg.Polygon(rings, style);
}

void DrawFree(SvgWriter& svg, const View& view, const FreeSpace& space, const GroundOptions& options) {
  std::vector<Ring> white;
  for (std::size_t i = 0; i < space.components.size(); ++i) {
    const FreeComponent& component = space.components[i];
    std::vector<Ring> rings = {view.ToPixels(component.outer.points)};
    for (const BoundaryRing& hole : component.holes) rings.push_back(view.ToPixels(hole.points));
    if (i < options.tints.size()) {
      svg.Polygon(rings, {.fill = options.tints[i], .stroke = kBoundaryColour, .width = 0.9});
    } else {
      white.insert(white.end(), rings.begin(), rings.end());
    }
  }
  svg.Polygon(white, {.fill = kFreeColour, .stroke = kBoundaryColour, .width = 0.9});
}

void OutlineObstacles(SvgWriter& svg, const View& view, const World& world) {
  for (const Obstacle& obstacle : world.obstacles) {
    if (obstacle.from_map) continue;
    DrawObstacle(svg, view, obstacle, {.stroke = kBoundaryColour, .width = 0.7, .dashes = "2 2"});
  }
}

}  // namespace

bool IsOpenPlane(const World& world) { return world.outline.empty(); }

SvgWriter StartPicture(const SvgWriter::Options& options) {
  SvgWriter svg(options);
  svg.DefineHatch(kClearanceColour, kClearanceLineColour);
  return svg;
}

void DrawGround(SvgWriter& svg, const View& view, const World& world, const FreeSpace& space,
                const GroundOptions& options) {
  const bool grown = space.clearance > 0;
  svg.OpenWindow("ground", options.frame);
  svg.Rectangle(options.frame, {.fill = IsOpenPlane(world) ? kFreeColour : grown ? kHatchFill : kBlockedColour});
  DrawFree(svg, view, space, options);
  if (grown) {
    DrawOriginals(svg, view, world, options);
  } else if (options.outline_obstacles) {
    OutlineObstacles(svg, view, world);
  }
  svg.CloseWindow();
  svg.Rectangle(options.frame, {.stroke = kBoundaryColour, .width = 0.8});
}

std::vector<LegendEntry> GroundLegend(const FreeSpace& space, int decimals) {
  std::vector<LegendEntry> entries = {{GroundSwatch{.fill = kBlockedColour}, "wall or obstacle", {}}};
  if (space.clearance > 0) {
    const int enough = DecimalsToTellApart(space.clearance, 0, decimals);
    entries.push_back({GroundSwatch{.fill = kClearanceColour, .hatched = true},
                       "clearance " + LengthText(space.clearance, enough),
                       {}});
  }
  return entries;
}

std::size_t BoundarySize(const FreeSpace& space) {
  std::size_t size = 0;
  for (const FreeComponent& component : space.components) {
    size += component.outer.points.size();
    for (const BoundaryRing& hole : component.holes) size += hole.points.size();
  }
  return size;
}

}  // namespace tautline
