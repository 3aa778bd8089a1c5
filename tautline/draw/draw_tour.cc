#include "tautline/draw/draw_tour.h"

#include <algorithm>

#include "tautline/draw/length_text.h"
#include "tautline/draw/workspace_layers.h"

namespace tautline {
namespace {

/// Beyond so many tasks, their numbers would hide the map.
constexpr std::size_t kMostNumbered = 60;

std::string Title(const Tour& tour, int decimals) {
  const std::string length = LengthText(tour.path.length, decimals);
  const std::string tasks = tour.order.size() == 1 ? "1 task" : std::to_string(tour.order.size()) + " tasks";
  return tour.optimal ? "The shortest tour over " + tasks + " is " + length : "A tour over " + tasks + " of " + length;
}

std::string OutsideTitle(const OutsideFault& fault) {
  if (fault.obstruction == WorkspaceObstruction::kStartOutside) return "No tour: the start is outside of the workspace";
  if (fault.obstruction == WorkspaceObstruction::kGoalOutside) return "No tour: the goal is outside of the workspace";
  const std::size_t tasks = fault.tasks.size();
  return tasks == 1 ? "No tour: a task is outside of the workspace"
                    : "No tour: " + std::to_string(tasks) + " tasks are outside of the workspace";
}

std::vector<std::string> Notes(const Tour& tour, int decimals) {
  std::vector<std::string> notes;
  if (!tour.optimal) {
    const double gap = tour.bound > 0 ? 100 * (tour.path.length / tour.bound - 1) : 0;
    notes.push_back("No tour is shorter than " + LengthText(tour.bound, decimals) + ": this one is at most " +
                    CompactText(gap, 2) + " % longer than the shortest.");
  }
  if (tour.stopped) notes.emplace_back("The search was stopped before its end.");
  if (tour.outside) notes.emplace_back("The path leaves the workspace beside a winch in the open.");
  return notes;
}

void MarkStops(Figure& figure, const TourPicture& picture) {
  const TourStops& stops = picture.stops;
  const OutsideFault none;
  const OutsideFault& fault = picture.tour ? none : picture.tour.error();
  for (std::size_t i = 0; i < stops.tasks.size(); ++i) {
    const bool outside = std::find(fault.tasks.begin(), fault.tasks.end(), i) != fault.tasks.end();
    if (outside) figure.Mark(Marker::kBlocked, stops.tasks[i], "task " + std::to_string(i + 1));
    if (!outside && !picture.tour) figure.Mark(Marker::kTask, stops.tasks[i]);
  }
  const auto mark = [&](WorkspaceObstruction obstruction, Marker marker, Point at, const std::string& name) {
    figure.Mark(fault.obstruction == obstruction ? Marker::kBlocked : marker, at, name);
  };
  mark(WorkspaceObstruction::kStartOutside, Marker::kRobot, stops.start, "start");
  if (stops.goal && *stops.goal != stops.start) {
    mark(WorkspaceObstruction::kGoalOutside, Marker::kGoal, *stops.goal, "goal");
  }
}

/// One number for each place: tasks at one place are visited one after the other.
void NumberTasks(Figure& figure, const TourPicture& picture) {
  const std::vector<std::size_t>& order = picture.tour->order;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Point at = picture.stops.tasks[order[i]];
    if (order.size() > kMostNumbered) {
      figure.Mark(Marker::kTask, at);
      continue;
    }
    std::string number = std::to_string(i + 1);
    while (i + 1 < order.size() && picture.stops.tasks[order[i + 1]] == at) number = std::to_string(++i + 1);
    const Polyline pixel{figure.view().ToPixels(at)};
    figure.Number(pixel, number, kPathLine.colour);
  }
}

}  // namespace

std::string DrawTour(const Scene& scene, const FreeSpace& space, const TourPicture& picture) {
  const int decimals = LengthDecimals(space);
  FigureContent content{.shown = WorkspacePoints(scene)};
  content.shown.insert(content.shown.end(), picture.stops.tasks.begin(), picture.stops.tasks.end());
  content.shown.push_back(picture.stops.start);
  if (picture.stops.goal) content.shown.push_back(*picture.stops.goal);
  content.legend = {{GroundSwatch{.fill = kWorkspaceFill, .edge = kWorkspaceLine.colour}, "workspace"},
                    {Marker::kWinch, "winch of a cable"}};
  if (picture.tour) {
    content.title = Title(*picture.tour, decimals);
    content.notes = Notes(*picture.tour, decimals);
    content.legend.push_back({kPathLine, "robot path " + LengthText(picture.tour->path.length, decimals)});
    if (picture.tour->order.size() > kMostNumbered) {
      content.legend.push_back({Marker::kTask, "task"});
    } else if (!picture.tour->order.empty()) {
      content.legend.push_back(
          {NumberedSwatch{"1", {.colour = kPathLine.colour, .width = 0}}, "task, by the order of the visit"});
    }
  } else {
    content.title = OutsideTitle(picture.tour.error());
    content.notes = {Sentence(picture.tour.error().explanation)};
  }
  Figure figure(scene, space, content);
  DrawWorkspaceArea(figure, picture.boundary.ring);
  if (picture.tour) {
    figure.Line("robot-path", picture.tour->path.points, kPathLine);
    NumberTasks(figure, picture);
  }
  MarkAnchors(figure, BasesOf(picture.anchors));
  MarkStops(figure, picture);
  return figure.Finish();
}

}  // namespace tautline
