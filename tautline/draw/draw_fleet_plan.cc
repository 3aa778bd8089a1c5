#include <algorithm>

#include "tautline/draw/curve.h"
#include "tautline/draw/draw_fleet.h"
#include "tautline/draw/figure.h"
#include "tautline/draw/fleet_graphs.h"
#include "tautline/draw/fleet_layers.h"
#include "tautline/draw/fleet_schedule.h"
#include "tautline/draw/length_text.h"
#include "tautline/draw/sheet.h"

namespace tautline {
namespace {

constexpr double kPadding = 24;  // Room for symbols on the rim of a map.
constexpr double kTallestMap = 480;
constexpr double kLowestMap = 150;
constexpr std::size_t kMostNamedCrossings = 40;      // With more, crossings are dots.
constexpr std::size_t kMostDottedCrossings = 3'000;  // With more, they are left out.
constexpr std::size_t kMostColumns = 22;             // Of the event graph.
constexpr double kArrowReach = 17;                   // Pixels from a crossing to the ends of its arrow.

bool OnDetour(const FleetPlan& plan, std::size_t robot) { return plan.schedule[robot].path.is_cable; }

std::string Sentences(const FleetGround& ground, const FleetPlan& plan) {
  std::string text;
  if (!plan.pair_deadlocks.empty()) {
    const PairDeadlock& first = plan.pair_deadlocks[0];
    text += "Pair deadlock of " + ground.robot(first.a).name + " and " + ground.robot(first.b).name;
    text +=
        plan.pair_deadlocks.size() > 1 ? ", and " + std::to_string(plan.pair_deadlocks.size() - 1) + " more. " : ". ";
  }
  for (std::size_t i = 0; i < std::min<std::size_t>(plan.network_deadlocks.size(), 2); ++i) {
    text += "On straight paths " + NamesText(ground, plan.network_deadlocks[i]) + " would wait for each other. ";
  }
  for (std::size_t i = 0; i < std::min<std::size_t>(plan.entangled.size(), 2); ++i) {
    text += "On straight paths " + NamesText(ground, plan.entangled[i]) + " would make another layout. ";
  }
  return text.empty() ? text : text.substr(0, text.size() - 1);
}

/// "straight-concurrent: 14 s, 21 m" for each mode, and what it takes.
LegendEntry ModesEntry(const FleetGround& ground, const FleetPlan& plan) {
  LegendEntry entry{std::monostate{}, "What each mode takes"};
  for (std::size_t k = 0; k < plan.modes.size(); ++k) {
    const ModeSummary& mode = plan.modes[k];
    entry.details.push_back(ToString(static_cast<FleetMode>(k)) + ": " + TimeText(mode.travel_time) + ", " +
                            LengthText(mode.travel_distance, FleetDecimals(ground)));
    if (!mode.realizable) entry.details.back() += ", with a detour of " + NamesText(ground, mode.detours);
  }
  return entry;
}

std::string PlanTitle(const FleetGround& ground, const FleetPlan& plan) {
  const std::string robots = ground.size() == 1 ? "One robot" : std::to_string(ground.size()) + " robots";
  std::string title = robots + ", " + ToString(plan.mode) + ": " + TimeText(plan.travel_time) + ", " +
                      LengthText(plan.travel_distance, FleetDecimals(ground)) + " driven";
  if (!plan.detours.empty()) {
    title += "; " + NamesText(ground, plan.detours) + " must follow " +
             (plan.detours.size() == 1 ? "its cable line" : "their cable lines");
  }
  return title;
}

/// An arrow from the path of the robot that passes first to the path of the other, just before they meet.
void DrawPriority(MapDrawing& map, const FleetPlan& plan, const Passing& passing) {
  const auto before = [&](RobotId robot, double along) {
    const Polyline line = map.view().ToPixels(plan.schedule[robot.index()].path.points);
    const double pixels = along * map.view().pixels_per_metre();
    return PositionAlong(line, std::max(0.0, pixels - kArrowReach)).at;
  };
  const Point at = map.view().ToPixels(passing.at);
  const Point from = before(passing.first, passing.first_along), to = before(passing.second, passing.second_along);
  const Point middle = Lerp(Lerp(from, to, 0.5), at, -0.45);
  if (Distance(from, to) < 3) return;
  map.KeepFree(BoundingBox(Polyline{from, middle, to}));
  map.svg().Smooth(Polyline{from, middle, to}, {.stroke = kHaloColour, .width = 3.4});
  map.svg().Smooth(Polyline{from, middle, to}, {.stroke = kInkColour, .width = 1.3});
  const Point way = to - middle;
  map.svg().ArrowHead(to - 3.5 / Norm(way) * way, way, 8, {.fill = kInkColour});
}

void DrawPaths(MapDrawing& map, const FleetGround& ground, const FleetPlan& plan) {
  for (std::size_t i = 0; i < plan.schedule.size(); ++i) {
    LineStyle style = RobotLine(RobotId(i), ground.size());
    if (OnDetour(plan, i)) style.width = std::max(2 * style.width, 1.2), style.dashes = "";
    style.arrows = ground.size() <= kMostInGraphs;
    map.Line(OnDetour(plan, i) ? "detour" : "path", plan.schedule[i].path.points, style);
  }
  const std::vector<Passing> passings = PassingsToKeep(plan);
  const bool named = passings.size() <= kMostNamedCrossings;
  if (passings.size() > kMostDottedCrossings) return;
  map.svg().OpenGroup("crossings");
  for (const Passing& p : passings) {
    if (named) DrawPriority(map, plan, p);
    if (named) map.Mark(Marker::kCrossing, p.at, p.label);
    if (!named) map.svg().Circle(map.view().ToPixels(p.at), 1.2, {.fill = kInkColour});
  }
  map.svg().CloseGroup();
}

/// Panels that share scene, box and free space.
struct MapPanels {
  const Scene& scene;
  const FreeSpace& space;
  Box box;

  double Height(double width) const {
    const double scale = (width - 2 * kPadding) / box.size().x;
    return std::clamp(scale * box.size().y + 2 * kPadding, kLowestMap, kTallestMap);
  }

  /// A map with what `draw` puts on it.
  template <class Draw>
  auto Panel(Draw draw) const {
    return [*this, draw](SvgWriter& svg, const Box& frame) {
      const Point padding{kPadding, kPadding};
      MapDrawing map(svg, {.world = scene.world,
                           .space = space,
                           .view = {box, {frame.low + padding, frame.high - padding}},
                           .options = {.frame = frame}});
      draw(map);
      map.Finish();
    };
  }
};

void AddMaps(const MapPanels& panels, const FleetGround& ground, const FleetPlanPicture& picture,
             std::vector<SheetRow>& rows) {
  const FleetPlan& plan = picture.plan;
  const std::size_t crossings = PassingsToKeep(plan).size();
  double lines = 0;
  for (const Route& route : picture.layout) lines += LengthOf(ground, route);
  const int decimals = FleetDecimals(ground);
  SheetPanel layout{.title = "Target layout",
                    .notes = {"cable lines, together " + LengthText(lines, decimals)},
                    .draw = panels.Panel([&](MapDrawing& map) {
                      DrawCableLines(map, ground, picture.layout);
                      MarkFleet(map, ground);
                    })};
  SheetPanel paths{.title = "Paths and who passes first",
                   .notes = {"together " + LengthText(plan.travel_distance, decimals) + ", " +
                             std::to_string(crossings) + (crossings == 1 ? " crossing" : " crossings")},
                   .draw = panels.Panel([&](MapDrawing& map) {
                     DrawPaths(map, ground, plan);
                     MarkFleet(map, ground);
                   })};
  const bool wide = panels.box.size().x > 2.2 * panels.box.size().y;
  const double width = wide ? SheetFrameWidth(1, 1, 1) : SheetFrameWidth(1, 2, 2);
  rows.push_back({.panels = {std::move(layout)}, .height = panels.Height(width)});
  if (wide) rows.push_back({.panels = {}, .height = panels.Height(width)});
  rows.back().panels.push_back(std::move(paths));
}

void AddGraphs(const EventGraphDrawing& events, const FleetGround& ground, const FleetPlan& plan,
               std::vector<SheetRow>& rows, std::vector<std::string>& notes) {
  if (ground.size() < 2) return;
  if (ground.size() > kMostInGraphs) {
    notes.push_back("With more than " + std::to_string(kMostInGraphs) + " robots the graphs are not drawn.");
    return;
  }
  const double height = std::max(190.0, 32.0 * static_cast<double>(ground.size()));
  SheetRow row{.panels = {{.title = "Who passes first",
                           .notes = {"crossings by pairs of robots"},
                           .draw = [&](SvgWriter& svg, const Box& frame) { DrawPairGraph(svg, frame, ground, plan); }}},
               .height = height};
  if (events.columns() <= kMostColumns) {
    row.panels.push_back(
        {.title = "Events on straight paths",
         .notes = {events.has_circle() ? "red: events that wait for each other in a circle" : "arrows: not later than"},
         .draw = [&](SvgWriter& svg, const Box& frame) { events.Draw(svg, frame, ground); },
         .share = 2.2});
  } else {
    notes.emplace_back("The graph of events is not drawn: it has too many.");
  }
  rows.push_back(std::move(row));
}

std::vector<LegendEntry> PlanLegend(const FleetPlan& plan, const FleetGround& ground) {
  std::vector<LegendEntry> legend = MarksLegend();
  if (!plan.passings.empty()) {
    legend.push_back({Marker::kCrossing, "crossing; an arrow leads from the robot that passes first"});
  }
  if (std::any_of(plan.schedule.begin(), plan.schedule.end(), [](const RobotSchedule& s) { return s.path.is_cable; })) {
    LineStyle line = RobotLine(RobotId(0), ground.size());
    legend.push_back({LineStyle{.colour = line.colour, .width = 2 * line.width}, "robot on its cable line"});
  }
  legend.push_back({GroundSwatch{.fill = kClearanceColour, .hatched = true}, "robot waits"});
  legend.push_back(ModesEntry(ground, plan));
  return legend;
}

}  // namespace

std::string DrawFleetPlan(const Scene& scene, const FleetGround& ground, const FleetPlanPicture& picture) {
  const FleetPlan& plan = picture.plan;
  const FreeSpace space = DrawnSpace(ground);
  const MapPanels panels{scene, space, FleetBox(ground)};
  SheetContent sheet{.title = PlanTitle(ground, plan), .rows = {}, .legend = PlanLegend(plan, ground)};
  if (std::string text = Sentences(ground, plan); !text.empty()) sheet.notes.push_back(std::move(text));
  sheet.notes.insert(sheet.notes.end(), picture.notes.begin(), picture.notes.end());
  AddMaps(panels, ground, picture, sheet.rows);
  const EventGraphDrawing events(ground.size() <= kMostInGraphs ? plan : FleetPlan{});
  AddGraphs(events, ground, plan, sheet.rows, sheet.notes);
  std::vector<GanttRow> rows = ScheduleRows(ground, plan);
  const std::string shown = rows.size() < ground.size()
                                ? "the " + std::to_string(rows.size()) + " robots that wait or drive longest"
                                : "speeds are constant between marks";
  const double height = GanttChart::HeightOf(rows.size());
  const auto draw = [&rows, &plan](SvgWriter& svg, const Box& frame) {
    GanttChart(frame, rows, plan.travel_time).Draw(svg);
  };
  sheet.rows.push_back({.panels = {{.title = "Schedule", .notes = {shown}, .draw = draw}}, .height = height});
  return DrawSheet(sheet);
}

}  // namespace tautline
