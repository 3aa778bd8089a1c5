#include "tautline/draw/draw_place.h"

#include "tautline/draw/length_text.h"
#include "tautline/draw/tether_layers.h"
#include "tautline/draw/workspace_layers.h"

namespace tautline {
namespace {

std::string Title(const PlacementGround& ground, const PlaceResult& result, int decimals) {
  if (result.status == PlaceStatus::kInfeasible) return "No place for the winches: a task cannot be held";
  if (result.status != PlaceStatus::kSolved) return "No place for the winches was found";
  const Placement& placement = *result.placement;
  const std::string winches = std::to_string(placement.anchors.size()) + " winches ";
  if (ground.options().objective == PlaceObjective::kCable) {
    return winches + "hold all tasks with " + LengthText(placement.worth.value, decimals) + " of cable";
  }
  return winches + "can move the robot in " + AreaText(placement.worth.value) + (placement.futures ? ", expected" : "");
}

std::vector<Point> BasesOf(const Anchors& anchors) {
  std::vector<Point> bases;
  for (const Socket& anchor : anchors) bases.push_back(anchor.base);
  return bases;
}

}  // namespace

std::string DrawPlace(const Scene& scene, const PlacementGround& ground, const PlaceResult& result) {
  const FreeSpace& space = ground.ground().space().free_space();
  const int decimals = LengthDecimals(space);
  FigureContent content{.title = Title(ground, result, decimals), .shown = scene.tasks};
  if (!result.explanation.empty()) content.notes.push_back(result.explanation);
  if (result.placement) {
    content.legend = {{GroundSwatch{.fill = kWorkspaceFill, .edge = kWorkspaceLine.colour}, "workspace"}};
    LegendEntry winches{Marker::kWinch, "winch, and the cable that it needs"};
    for (std::size_t i = 0; i < result.placement->longest_cables.size(); ++i) {
      winches.details.push_back(std::to_string(i + 1) + ": " +
                                LengthText(result.placement->longest_cables[i], decimals));
    }
    content.legend.push_back(std::move(winches));
  }
  if (!scene.tasks.empty()) content.legend.push_back({Marker::kTask, "task"});
  Figure figure(scene, space, content);
  if (result.placement) {
    DrawWorkspaceArea(figure, result.placement->boundary.ring);
    MarkAnchors(figure, BasesOf(result.placement->anchors));
  }
  MarkTasks(figure, scene);
  return figure.Finish();
}

}  // namespace tautline
