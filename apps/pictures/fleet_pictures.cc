#include "apps/pictures/fleet_pictures.h"

#include "tautline/draw/figure.h"
#include "tautline/draw/line_style.h"

namespace tautline {
namespace {

std::string DrawCables(const Scene& scene, const FleetSetup& setup, const FleetLayout& layout,
                       const FigureContent& content) {
  const FreeSpace plane;
  const FreeSpace& space = setup.ground.space() != nullptr ? setup.ground.space()->free_space() : plane;
  FigureContent shown = content;
  for (const FleetRobot& robot : setup.ground.robots()) shown.shown.insert(shown.shown.end(), {robot.start, robot.target});
  Figure figure(scene, space, shown);
  for (const Route& route : layout) figure.Line("cable", PointsOf(setup.ground, route), {});
  for (const FleetRobot& robot : setup.ground.robots()) {
    figure.Mark(Marker::kBase, robot.start, "S " + robot.name);
    figure.Mark(Marker::kGoal, robot.target, "T " + robot.name);
  }
  return figure.Finish();
}

}  // namespace

std::string DrawAnswer(const Scene& scene, const CheckAnswer& answer) {
  const auto& layout = *answer.setup.layout;
  FigureContent content{.title = answer.status == kExitSolved ? "The layout is free of crossings"
                                                              : "The layout cannot be made",
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
