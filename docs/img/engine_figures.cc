// The figures of docs/engine.md that no command draws: what the engine computes on the way to an answer.
//
// engine_figures SCENE FOLDER writes sleeve.svg, visibility_graph.svg and tether_along.svg. The scene needs a tether
// that is laid and a goal.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "tautline/draw/figure.h"
#include "tautline/draw/length_text.h"
#include "tautline/draw/tether_layers.h"
#include "tautline/homotopy/taut_space.h"
#include "tautline/planners/tether/tether_planner.h"
#include "tautline/scene/scene_file.h"

namespace tautline {
namespace {

const LineStyle kMeshLine = {.colour = "#9aa0a6", .width = 0.8};
const LineStyle kPortalLine = {.colour = "#c4457a", .width = 2.2, .dashes = "6 3"};
const LineStyle kSharedEdgeLine = {.colour = "#00684c", .width = 1.2};

Polyline EdgeOf(const FreeMesh& mesh, TriangleId id, int i) {
  const auto& vertices = mesh.triangle(id).vertices;
  return {mesh.point(vertices[static_cast<std::size_t>(Next(i))]),
          mesh.point(vertices[static_cast<std::size_t>(Previous(i))])};
}

/// The triangulation, the sleeve of the laid cable with its portals, and the taut curve through them.
std::string DrawSleeve(const Scene& scene, const TetherPlanner& planner) {
  const FreeMesh& mesh = planner.space().mesh();
  const LaidCable laid = planner.FollowLaidCable(*scene.tether).value();
  const auto sleeve = laid.walk.sleeve.triangles();
  const TautPath taut = planner.TetherAlong(laid.socket, laid.walk);
  Figure figure(scene, planner.space().free_space(),
                {.title = "A sleeve of " + std::to_string(sleeve.size()) + " triangles, pulled tight to " +
                          LengthText(taut.length, 2),
                 .legend = {{kLaidLine, "cable as laid"},
                            {kMeshLine, "triangulation of the free ground"},
                            {kPortalLine, "portal", {"between two triangles of the sleeve"}},
                            {kTautLine, "the taut curve", {"the shortest way through all portals"}}}});
  for (std::size_t t = 0; t < mesh.triangulation().triangles().size(); ++t) {
    const TriangleId id(t);
    for (int i = 0; mesh.IsFree(id) && i < 3; ++i) figure.Line("mesh", EdgeOf(mesh, id, i), kMeshLine);
  }
  for (std::size_t k = 1; k < sleeve.size(); ++k) {
    const int i = mesh.triangle(sleeve[k - 1]).IndexOf(sleeve[k]);
    figure.Line("portals", EdgeOf(mesh, sleeve[k - 1], i), kPortalLine);
  }
  figure.Line("taut", taut.points, kTautLine);
  DrawLaid(figure, scene);
  figure.Mark(Marker::kBase, scene.tether->base, "base");
  figure.Mark(Marker::kRobot, RobotPosition(*scene.tether), "robot");
  return figure.Finish();
}

/// All bitangents between corners.
std::string DrawGraph(const Scene& scene, const TetherPlanner& planner) {
  const Corners& corners = planner.space().corners();
  const auto edges = planner.space().graph().edges();
  Figure figure(
      scene, planner.space().free_space(),
      {.title = std::to_string(corners.size()) + " corners, " + std::to_string(edges.size() / 2) +
                " bitangents of the " + std::to_string(corners.size() * (corners.size() - 1) / 2) + " pairs of corners",
       .legend = {{Marker::kPoint, "corner", {"where a taut curve can bend"}},
                  {kSharedEdgeLine, "bitangent", {"an edge of the graph in both directions"}}}});
  for (const TautEdge& edge : edges) {
    if (edge.to < edge.from) continue;
    figure.Line("bitangents", Polyline{corners[edge.from].point, corners[edge.to].point}, kSharedEdgeLine);
  }
  for (const Corner& corner : corners.all()) figure.Mark(Marker::kPoint, corner.point);
  return figure.Finish();
}

/// The tether's length at even steps along a path: (distance travelled, tether length), metres.
std::vector<Point> TetherAlongPath(const TetherPlanner& planner, const LaidCable& laid, const Polyline& path) {
  constexpr int kStepsPerLeg = 40;
  std::optional<Walk> walk = laid.walk;
  std::vector<Point> samples{{0, planner.TetherAlong(laid.socket, *walk).length}};
  for (std::size_t i = 1; i < path.size(); ++i) {
    for (int k = 1; k <= kStepsPerLeg; ++k) {
      const Point leg[] = {Lerp(path[i - 1], path[i], static_cast<double>(k) / kStepsPerLeg)};
      const double step = Distance(path[i - 1], path[i]) / kStepsPerLeg;
      if (planner.space().Follow(leg, walk)) std::fputs("the path leaves the free ground\n", stderr);
      samples.push_back({samples.back().x + step, planner.TetherAlong(laid.socket, *walk).length});
    }
  }
  return samples;
}

/// A chart with metres on both axes.
class Chart {
 public:
  Chart(double width_m, double height_m) : width_m_(width_m), height_m_(height_m) {}

  Point At(Point p) const { return {90 + p.x / width_m_ * 640, 400 - p.y / height_m_ * 330}; }

  void DrawAxes(SvgWriter& svg) const {
    svg.Polyline(std::vector{At({0, height_m_}), At({0, 0}), At({width_m_, 0})}, {.stroke = kInkColour, .width = 1.2});
    for (double x = 0; x <= width_m_; x += 2) {
      svg.Text({.at = At({x, 0}) + Point{0, 18}, .text = CompactText(x, 0), .anchor = TextAnchor::kMiddle});
    }
    for (double y = 0; y <= height_m_; y += 2) {
      svg.Text({.at = At({0, y}) + Point{-10, 4}, .text = CompactText(y, 0), .anchor = TextAnchor::kEnd});
    }
    svg.Text({.at = {410, 440}, .text = "way of the robot, m", .size = 13, .anchor = TextAnchor::kMiddle});
    svg.Text({.at = {60, 58}, .text = "taut tether, m", .size = 13});
  }

  void DrawCurve(SvgWriter& svg, const std::vector<Point>& samples, const SvgStyle& style) const {
    Polyline line;
    for (const Point p : samples) line.push_back(At(p));
    svg.Polyline(line, style);
    svg.Circle(line.front(), 3.5, {.fill = style.stroke});
    svg.Circle(line.back(), 3.5, {.fill = style.stroke});
  }

 private:
  double width_m_, height_m_;
};

/// How much tether is out on the way, for the motion that was chosen and the one that was rejected.
std::string DrawTetherAlong(const Scene& scene, const TetherPlanner& planner) {
  const PlanResult result = planner.Plan(*scene.tether, *scene.goal);
  const LaidCable laid = planner.FollowLaidCable(*scene.tether).value();
  const auto chosen = TetherAlongPath(planner, laid, result.motion.value().path.points);
  const auto rejected = TetherAlongPath(planner, laid, result.rejected.value().path.points);
  SvgWriter svg({.width = 800, .height = 460, .title = "The tether along two motions"});
  svg.Rectangle({{0, 0}, {800, 460}}, {.fill = "#ffffff"});
  const Chart chart(chosen.back().x, 1.1 * std::max(result.limit, rejected.back().y));
  svg.Text({.at = {20, 28},
            .text = "The tether along two motions: convex, so greatest at an end",
            .size = 17,
            .bold = true});
  chart.DrawAxes(svg);
  const Point limit_end = chart.At({chosen.back().x, result.limit});
  svg.Polyline(std::vector{chart.At({0, result.limit}), limit_end},
               {.stroke = kInkColour, .width = 1.2, .dashes = "2 4"});
  const std::string limit = "limit " + LengthText(result.limit, 2);
  svg.Text({.at = limit_end + Point{-4, -7}, .text = limit, .anchor = TextAnchor::kEnd});
  chart.DrawCurve(svg, rejected, {.stroke = kRejectedLine.colour, .width = 2.2, .dashes = kRejectedLine.dashes});
  chart.DrawCurve(svg, chosen, {.stroke = kPathLine.colour, .width = 2.4});
  svg.Text({.at = chart.At(rejected.back()) + Point{10, -6},
            .text = "rejected: ends at " + LengthText(rejected.back().y, 2),
            .fill = kRejectedLine.colour});
  svg.Text({.at = chart.At(chosen.back()) + Point{-10, 46},
            .text = "chosen: ends at " + LengthText(chosen.back().y, 2),
            .anchor = TextAnchor::kEnd,
            .fill = kPathLine.colour});
  return svg.Finish();
}

int Main(const std::string& scene_path, const std::string& folder) {
  const auto scene = ReadSceneFile(scene_path);
  if (!scene) return std::fprintf(stderr, "%s\n", ToString(scene.error()).c_str()), 2;
  const auto planner = TetherPlanner::Prepare(scene->world);
  if (!planner) return std::fprintf(stderr, "%s\n", ToString(planner.error()).c_str()), 2;
  std::ofstream(folder + "/sleeve.svg") << DrawSleeve(*scene, *planner);
  std::ofstream(folder + "/visibility_graph.svg") << DrawGraph(*scene, *planner);
  std::ofstream(folder + "/tether_along.svg") << DrawTetherAlong(*scene, *planner);
  return 0;
}

}  // namespace
}  // namespace tautline

int main(int argc, char** argv) {
  if (argc != 3) return std::fprintf(stderr, "engine_figures SCENE FOLDER\n"), 2;
  return tautline::Main(argv[1], argv[2]);
}
