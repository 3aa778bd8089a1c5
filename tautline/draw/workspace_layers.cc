#include "tautline/draw/workspace_layers.h"

namespace tautline {
namespace {

constexpr double kAreaOpacity = 0.15;

}  // namespace

std::vector<Point> WorkspacePoints(const Scene& scene) {
  std::vector<Point> points = scene.tasks;
  if (scene.goal) points.push_back(*scene.goal);
  if (!scene.cables) return points;
  points.insert(points.end(), scene.cables->anchors.begin(), scene.cables->anchors.end());
  if (!scene.cables->laid) return points;
  for (const Polyline& cable : *scene.cables->laid) points.insert(points.end(), cable.begin(), cable.end());
  return points;
}

void DrawWorkspaceArea(Figure& figure, std::span<const Point> ring) {
  if (ring.empty()) return;
  SvgCurve curve{.start = figure.view().ToPixels(ring[0]), .steps = {}, .closed = true};
  for (std::size_t i = 1; i < ring.size(); ++i) curve.steps.push_back({.to = figure.view().ToPixels(ring[i])});
  curve.steps.push_back({.to = curve.start});
  figure.Shape("workspace", std::span<const SvgCurve>(&curve, 1),
               {.fill = kWorkspaceLine.colour, .opacity = kAreaOpacity});
  Polyline closed(ring.begin(), ring.end());
  closed.push_back(ring[0]);
  figure.Line("boundary", closed, kWorkspaceLine);
}

std::vector<Point> BasesOf(const Anchors& anchors) {
  std::vector<Point> bases;
  for (const Socket& anchor : anchors) bases.push_back(anchor.base);
  return bases;
}

std::string Sentence(std::string explanation) {
  if (explanation.empty()) return explanation;
  char& first = explanation[0];
  if (first >= 'a' && first <= 'z') first = static_cast<char>(first - 'a' + 'A');
  return explanation + ".";
}

void MarkAnchors(Figure& figure, std::span<const Point> anchors) {
  for (std::size_t i = 0; i < anchors.size(); ++i) figure.Mark(Marker::kWinch, anchors[i], std::to_string(i + 1));
}

void MarkTasks(Figure& figure, const Scene& scene) {
  for (const Point task : scene.tasks) figure.Mark(Marker::kTask, task);
}

void DrawLaidCables(Figure& figure, const Scene& scene) {
  if (!scene.cables || !scene.cables->laid) return;
  for (const Polyline& cable : *scene.cables->laid) figure.Line("laid-cable", cable, kLaidLine);
  figure.Mark(Marker::kRobot, scene.cables->laid->front().front(), "robot");
}

std::vector<LegendEntry> WorkspaceLegend(const Scene& scene, bool has_area) {
  std::vector<LegendEntry> legend;
  if (has_area) {
    legend.push_back({GroundSwatch{.fill = kWorkspaceFill, .edge = kWorkspaceLine.colour}, "workspace"});
  }
  legend.push_back({Marker::kWinch, "winch of a cable"});
  if (scene.cables && scene.cables->laid) legend.push_back({kLaidLine, "cable as laid"});
  if (!scene.tasks.empty()) legend.push_back({Marker::kTask, "task"});
  return legend;
}

}  // namespace tautline
