#include "tautline/draw/draw_workspace.h"

#include <algorithm>
#include <cmath>

#include "tautline/draw/length_text.h"
#include "tautline/draw/obstacle_names.h"
#include "tautline/draw/tether_layers.h"
#include "tautline/draw/workspace_layers.h"

namespace tautline {
namespace {

/// Up to so many sides are listed one by one.
constexpr std::size_t kMostListed = 8;

std::string SideText(std::size_t side, std::size_t anchors) {
  return std::to_string(side + 1) + " to " + std::to_string(NextAnchor(side, anchors) + 1);
}

std::vector<LegendEntry> SidesLegend(const FreeSpace& space, const WorkspacePicture& picture) {
  const int decimals = LengthDecimals(space);
  std::vector<LegendEntry> legend;
  if (!picture.boundary || picture.boundary->sides.size() > kMostListed) return legend;
  const std::size_t n = picture.boundary->sides.size();
  LegendEntry sides{kWorkspaceLine, "boundary " + LengthText(picture.boundary->length, decimals)};
  for (std::size_t i = 0; i < n; ++i) {
    const TautPath& path = picture.boundary->sides[i].path;
    sides.details.push_back(SideText(i, n) + ": " + LengthText(path.length, decimals) + ", " +
                            WordText(path.word, space));
  }
  legend.push_back(std::move(sides));
  if (picture.longest.empty()) return legend;
  LegendEntry cables{std::monostate{}, "longest cable of each winch"};
  for (std::size_t i = 0; i < picture.longest.size(); ++i) {
    cables.details.push_back(std::to_string(i + 1) + ": " + LengthText(picture.longest[i].length, decimals) + " at " +
                             std::to_string(picture.longest[i].farthest + 1));
  }
  legend.push_back(std::move(cables));
  return legend;
}

std::set<ObstacleId> LettersOf(const WorkspaceBoundary& boundary) {
  std::set<ObstacleId> letters;
  for (const BoundarySide& side : boundary.sides) letters.merge(IslandsOf(side.path.word));
  return letters;
}

/// The sides as far as they are known, those at fault over the others.
void DrawFault(Figure& figure, const BoundaryFault& fault) {
  const auto at_fault = [&fault](std::size_t i) {
    return std::find(fault.sides.begin(), fault.sides.end(), i) != fault.sides.end();
  };
  for (const bool faulty : {false, true}) {
    for (std::size_t i = 0; i < fault.curves.size(); ++i) {
      if (at_fault(i) == faulty) figure.Line("side", fault.curves[i].points, faulty ? kFaultLine : kWorkspaceLine);
    }
  }
  if (fault.at) figure.Mark(Marker::kBlocked, *fault.at);
}

}  // namespace

std::string DrawWorkspace(const Scene& scene, const FreeSpace& space, const WorkspacePicture& picture) {
  const bool valid = picture.boundary.has_value();
  FigureContent content{.legend = WorkspaceLegend(scene, valid), .shown = WorkspacePoints(scene)};
  if (valid) {
    content.title = "The cables can move the robot in " + AreaText(picture.boundary->area);
  } else {
    content.title = "No workspace";
    content.notes = {Sentence(picture.boundary.error().explanation)};
    content.legend.push_back({kFaultLine, "side at fault"});
  }
  for (LegendEntry& entry : SidesLegend(space, picture)) content.legend.push_back(std::move(entry));
  Figure figure(scene, space, content);
  if (valid) {
    DrawWorkspaceArea(figure, picture.boundary->ring);
    const std::set<ObstacleId> letters = LettersOf(*picture.boundary);
    figure.Rays(letters);
    figure.Name(letters);
  } else {
    DrawFault(figure, picture.boundary.error());
  }
  DrawLaidCables(figure, scene);
  MarkAnchors(figure, BasesOf(picture.anchors));
  MarkTasks(figure, scene);
  return figure.Finish();
}

std::string DrawPose(const Scene& scene, const FreeSpace& space, const PosePicture& picture) {
  const int decimals = LengthDecimals(space);
  const Pose& pose = picture.pose;
  FigureContent content{.legend = {{GroundSwatch{.fill = kWorkspaceFill, .edge = kWorkspaceLine.colour}, "workspace"},
                                   {Marker::kWinch, "winch of a cable"}},
                        .shown = WorkspacePoints(scene)};
  content.shown.push_back(picture.at);
  if (pose.position == Containment::kOutside) {
    content.title = "The robot cannot be there: that is outside of the workspace";
  } else {
    const std::string gap = CompactText(pose.largest_gap * 180 / 3.14159265358979323846, 1) + "°";
    content.title = pose.spans ? "The cables hold the robot and can move it any way"
                               : "The cables cannot pull the robot every way: it is at the boundary";
    content.notes = {"The widest angle between two cables is " + gap + "; below 180° they can pull any way."};
    LegendEntry cables{kCableLine, "taut cable"};
    for (std::size_t i = 0; i < pose.cables.size(); ++i) {
      cables.details.push_back(std::to_string(i + 1) + ": " + LengthText(pose.cables[i].length, decimals));
    }
    content.legend.push_back(std::move(cables));
  }
  Figure figure(scene, space, content);
  DrawWorkspaceArea(figure, picture.boundary->ring);
  for (const PoseCable& cable : pose.cables) figure.Line("cable", cable.path.points, kCableLine);
  figure.Mark(pose.position == Containment::kOutside ? Marker::kBlocked : Marker::kRobot, picture.at, "pose");
  MarkAnchors(figure, BasesOf(picture.anchors));
  return figure.Finish();
}

}  // namespace tautline
