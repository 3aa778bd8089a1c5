// What pictures of a robot moved by cables share: its winches, its workspace, its cables.
#ifndef TAUTLINE_DRAW_WORKSPACE_LAYERS_H_
#define TAUTLINE_DRAW_WORKSPACE_LAYERS_H_

#include <span>
#include <string>
#include <vector>

#include "tautline/draw/figure.h"
#include "tautline/planners/cable_workspace/boundary.h"

namespace tautline {

/// The fill of a workspace, as it looks over white ground: for legends.
inline constexpr char kWorkspaceFill[] = "#d9ebe5";

/// Everything that the map should hold besides the world: anchors, laid cables, tasks and goal.
std::vector<Point> WorkspacePoints(const Scene& scene);

/// Shades a workspace and draws its boundary over the ground.
void DrawWorkspaceArea(Figure& figure, std::span<const Point> ring);

/// Where cables are tied, by anchor.
std::vector<Point> BasesOf(const Anchors& anchors);

/// An explanation with a capital letter and a full stop.
std::string Sentence(std::string explanation);

/// Marks the anchors as "1", "2", ..., counted as in explanations.
void MarkAnchors(Figure& figure, std::span<const Point> anchors);

/// Marks the tasks of the scene.
void MarkTasks(Figure& figure, const Scene& scene);

/// Draws the cables as they are laid, if they are, and the robot.
void DrawLaidCables(Figure& figure, const Scene& scene);

/// The entries of the legend for what the functions above draw.
std::vector<LegendEntry> WorkspaceLegend(const Scene& scene, bool has_area);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_WORKSPACE_LAYERS_H_
