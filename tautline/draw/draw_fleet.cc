#include "tautline/draw/draw_fleet.h"

#include <algorithm>

#include "tautline/draw/figure.h"
#include "tautline/draw/fleet_layers.h"
#include "tautline/draw/length_text.h"
#include "tautline/draw/sheet.h"

namespace tautline {
namespace {

constexpr std::size_t kMostExplained = 12;  // Rings with their text on the map.
constexpr std::size_t kMostRinged = 40;     // With more faults, their places are small circles.
constexpr std::size_t kMostListed = 12;     // Robots with their own line in the legend.
constexpr double kPadding = 16;             // Room for symbols on the rim of a small map.
constexpr double kTargetLineWidth = 6;

/// The cable lines as the scene has them.
void DrawGivenCables(Figure& figure, const FleetGround& ground) {
  for (std::size_t i = 0; i < ground.size(); ++i) {
    const auto& cable = ground.robots()[i].cable;
    if (cable) figure.Line("cable-line", *cable, RobotLine(RobotId(i), ground.size()));
  }
}

/// Rings; of many faults, dots without words.
void RingFaults(MapDrawing& map, const std::vector<LayoutMark>& marks) {
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (marks.size() <= kMostRinged) {
      map.Mark(Marker::kRing, marks[i].at, i < kMostExplained ? marks[i].text : "");
    } else {
      map.svg().Circle(map.view().ToPixels(marks[i].at), 2.5, {.stroke = kWarningColour, .width = 1.4});
    }
  }
}

std::vector<LegendEntry> LayoutLegend(const FleetGround& ground, const LayoutPicture& picture) {
  std::vector<LegendEntry> legend = MarksLegend();
  if (!picture.marks.empty()) legend.push_back({Marker::kRing, "what is wrong"});
  if (picture.layout != nullptr && picture.layout->empty()) return legend;
  if (ground.size() > kMostListed) {
    legend.push_back({RobotLine(RobotId(0), ground.size()), "target cable line"});
    return legend;
  }
  for (std::size_t i = 0; i < ground.size(); ++i) {
    LegendEntry entry{RobotLine(RobotId(i), ground.size()), "cable line of " + ground.robots()[i].name};
    if (picture.layout != nullptr) {
      const double length = LengthOf(ground, (*picture.layout)[i]);
      entry.details.push_back(LengthText(length, FleetDecimals(ground)));
    }
    legend.push_back(std::move(entry));
  }
  return legend;
}

}  // namespace

std::string DrawLayout(const Scene& scene, const FleetGround& ground, const LayoutPicture& picture) {
  const FreeSpace space = DrawnSpace(ground);
  const FigureContent content{.title = picture.title,
                              .notes = picture.notes,
                              .legend = LayoutLegend(ground, picture),
                              .shown = FleetPoints(ground)};
  Figure figure(scene, space, content);
  if (picture.layout != nullptr) {
    DrawCableLines(figure.map(), ground, *picture.layout);
  } else {
    DrawGivenCables(figure, ground);
  }
  RingFaults(figure.map(), picture.marks);
  MarkFleet(figure.map(), ground);
  return figure.Finish();
}

std::string DrawLayouts(const Scene& scene, const FleetGround& ground, const LayoutsPicture& picture) {
  const FreeSpace space = DrawnSpace(ground);
  const Box box = FleetBox(ground);
  const double aspect = box.size().x / box.size().y;
  const std::size_t columns = aspect > 2.2 ? 2 : aspect > 1.3 ? 3 : 4;
  const auto shares = static_cast<double>(columns);
  const double width = SheetFrameWidth(1, shares, columns);
  const double height = std::min(500.0, (width - 2 * kPadding) / aspect + 2 * kPadding);
  SheetContent sheet{.title = picture.title, .notes = picture.notes, .rows = {}, .legend = MarksLegend()};
  for (std::size_t k = 0; k < std::min(picture.layouts.size(), kMostLayoutsDrawn); ++k) {
    if (k % columns == 0) sheet.rows.push_back({.panels = {}, .height = height, .shares = shares});
    const FleetLayout& layout = *picture.layouts[k];
    double length = 0;
    for (const Route& route : layout) length += LengthOf(ground, route);
    const auto draw = [&](SvgWriter& svg, const Box& frame) {
      MapDrawing map(svg,
                     {.world = scene.world,
                      .space = space,
                      .view = {box, {frame.low + Point{kPadding, kPadding}, frame.high - Point{kPadding, kPadding}}},
                      .options = {.frame = frame}});
      DrawCableLines(map, ground, layout);
      MarkFleet(map, ground);
      map.Finish();
    };
    sheet.rows.back().panels.push_back(
        {.title = std::to_string(k + 1) + ": " + LengthText(length, FleetDecimals(ground)), .notes = {}, .draw = draw});
  }
  return DrawSheet(sheet);
}

namespace {

std::string SimulateTitle(const FleetGround& ground, const Playback& playback) {
  if (playback.differing.empty()) {
    return playback.broken.empty() ? "The layout came out" : "The layout came out, but orders were not kept";
  }
  const bool one = playback.differing.size() == 1;
  return "The layout did not come out: the cable" + std::string(one ? "" : "s") + " of " +
         NamesText(ground, playback.differing) + (one ? " lies" : " lie") + " differently";
}

std::vector<LegendEntry> SimulateLegend(const FleetGround& ground, const SimulatePicture& picture) {
  LineStyle wanted = RobotLine(RobotId(0), ground.size());
  wanted.colour = "#d9dce0";
  wanted.width = kTargetLineWidth;
  wanted.dashes.clear();
  std::vector<LegendEntry> legend = MarksLegend();
  if (!picture.layout.empty()) legend.push_back({wanted, "cable line that was to come out"});
  if (!picture.playback.differing.empty()) legend.push_back({kFaultLine, "cable that lies differently"});
  if (!picture.playback.broken.empty()) legend.push_back({Marker::kRing, "passed in the wrong order"});
  if (ground.size() > kMostListed) {
    legend.push_back({RobotLine(RobotId(0), ground.size()), "cable at the end"});
    return legend;
  }
  const int decimals = FleetDecimals(ground);
  for (std::size_t i = 0; i < ground.size(); ++i) {
    LegendEntry entry{RobotLine(RobotId(i), ground.size()), "cable of " + ground.robots()[i].name + " at the end"};
    entry.details.push_back(LengthText(LengthOf(ground, picture.playback.final_routes[i]), decimals));
    if (i < picture.playback.longest.size()) {
      const LongestTether& longest = picture.playback.longest[i];
      entry.details.back() += ", at most " + LengthText(longest.length, decimals) + " at " + TimeText(longest.t);
    }
    legend.push_back(std::move(entry));
  }
  return legend;
}

void DrawWanted(Figure& figure, const FleetGround& ground, const FleetLayout& layout) {
  for (const Polyline& track : CableTracks(figure.view(), ground, layout)) {
    figure.PixelLine("wanted", track, {.colour = "#d9dce0", .width = kTargetLineWidth});
  }
}

}  // namespace

std::string DrawSimulate(const Scene& scene, const FleetGround& ground, const SimulatePicture& picture) {
  const FreeSpace space = DrawnSpace(ground);
  const Playback& playback = picture.playback;
  FigureContent content{.title = SimulateTitle(ground, playback),
                        .legend = SimulateLegend(ground, picture),
                        .shown = FleetPoints(ground)};
  for (const Route& route : playback.final_routes) {
    for (const Point p : PointsOf(ground, route)) content.shown.push_back(p);
  }
  Figure figure(scene, space, content);
  DrawWanted(figure, ground, picture.layout);
  const std::vector<Polyline> tracks = CableTracks(figure.view(), ground, playback.final_routes);
  for (const bool faulty : {false, true}) {
    for (std::size_t i = 0; i < tracks.size(); ++i) {
      const auto& differing = playback.differing;
      if ((std::find(differing.begin(), differing.end(), RobotId(i)) != differing.end()) != faulty) continue;
      const LineStyle style = RobotLine(RobotId(i), ground.size());
      figure.PixelLine("final-cable", tracks[i], faulty ? kFaultLine : style);
      if (!faulty || differing.size() > kMostExplained) continue;
      figure.LabelLine(PointsOf(ground, playback.final_routes[i]), "cable of " + ground.robots()[i].name, style.colour);
    }
  }
  for (const BrokenOrder& broken : playback.broken) {
    figure.Mark(Marker::kRing, broken.at,
                playback.broken.size() > kMostExplained
                    ? ""
                    : ground.robot(broken.second).name + " passed before " + ground.robot(broken.first).name);
  }
  MarkFleet(figure.map(), ground);
  return figure.Finish();
}

}  // namespace tautline
