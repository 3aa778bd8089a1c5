#include "apps/pictures/fleet_pictures.h"

#include "tautline/draw/figure.h"
#include "tautline/draw/line_style.h"
#include "tautline/draw/view.h"

namespace tautline {
namespace {

/// A fleet alone in the plane, with a frame around it.
Scene Framed(Scene scene) {
  Polyline ends;
  for (const FleetRobot& robot : scene.fleet->robots) ends.insert(ends.end(), {robot.start, robot.target});
  const Box box = WithoutFlatSides(BoundingBox(ends));
  const Point margin = 0.08 * Point{Norm(box.size()), Norm(box.size())};
  const Point low = box.low - margin, high = box.high + margin;
  scene.world.outline = {low, {high.x, low.y}, high, {low.x, high.y}};
  return scene;
}

std::string DrawCables(const Scene& given, const FleetSetup& setup, const FleetLayout& layout,
                       const FigureContent& content) {
  const bool in_plane = setup.ground.space() == nullptr;
  const Scene scene = in_plane ? Framed(given) : given;
  const Expected<FreeSpace> frame = in_plane ? BuildFreeSpace(scene.world) : tl::unexpected(Error{});
  const FreeSpace& space = in_plane ? frame.value() : setup.ground.space()->free_space();
  Figure figure(scene, space, content);
  for (const Route& route : layout) figure.Line("cable", PointsOf(setup.ground, route), kCableLine);
  for (const FleetRobot& robot : setup.ground.robots()) {
    figure.Mark(Marker::kBase, robot.start, robot.name);
    figure.Mark(Marker::kGoal, robot.target, robot.name);
  }
  return figure.Finish();
}

}  // namespace

std::string DrawAnswer(const Scene& scene, const CheckAnswer& answer) {
  const auto& layout = *answer.setup.layout;
  FigureContent content{
      .title = answer.status == kExitSolved ? "The layout is free of crossings" : "The layout cannot be made",
      .notes = answer.explanations};
  if (content.notes.size() > 5) content.notes.resize(5);
  return DrawCables(scene, answer.setup, layout ? *layout : FleetLayout{}, content);
}

std::string DrawAnswer(const Scene& scene, const LayoutsAnswer& answer) {
  const auto& layouts = answer.result.layouts;
  return DrawCables(scene, answer.setup, layouts.empty() ? FleetLayout{} : layouts.front().routes,
                    {.title = layouts.empty() ? "No layout" : "The shortest layout"});
}

}  // namespace tautline
