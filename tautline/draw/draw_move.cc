#include "tautline/draw/draw_move.h"

#include <algorithm>
#include <cmath>

#include "tautline/draw/length_text.h"
#include "tautline/draw/workspace_layers.h"

namespace tautline {
namespace {

constexpr double kCableWidth = 1.9;
constexpr double kLaterCableWidth = 0.7;
constexpr int kLaterTimes = 3;       // Between start and goal.
constexpr int kPointsOfCurve = 400;  // Over the whole motion.

constexpr std::size_t kMostMarked = 12;  // Switches on the map; the plots have all.

const LineStyle kSpeedLine = {.colour = "#7a7a7a", .width = 1.2};

LineStyle WinchLine(const Move& move, std::size_t winch) {
  LineStyle style = ClassLine(static_cast<int>(winch), static_cast<int>(move.pieces[0].cables.size()));
  style.width = kCableWidth;
  return style;
}

std::string WinchName(std::size_t winch) { return "winch " + std::to_string(winch + 1); }

std::string SecondsText(double seconds) { return CompactText(seconds, seconds < 10 ? 3 : 1) + " s"; }

/// The distances along a piece at which its curves are drawn: evenly in time, and where sections meet.
std::vector<double> DistancesOf(const Move& move, const MovePiece& piece) {
  const double duration = piece.profile.duration_s();
  const double share = move.duration_s > 0 ? duration / move.duration_s : 1;
  const int steps = std::max(2, static_cast<int>(kPointsOfCurve * share));
  std::vector<double> distances;
  for (int i = 0; i <= steps; ++i) distances.push_back(piece.profile.At(duration * i / steps).distance);
  for (const auto& sections : piece.cables) {
    for (const CableSection& section : sections) distances.push_back(section.begin);
  }
  std::sort(distances.begin(), distances.end());
  return distances;
}

/// Curves of all winches over time.
struct Curves {
  std::vector<PlotSeries> lengths;
  std::vector<PlotSeries> rates;
};

Curves DrawnCurves(const Move& move) {
  const std::size_t winches = move.pieces[0].cables.size();
  Curves curves;
  for (std::size_t i = 0; i < winches; ++i) {
    curves.lengths.push_back({WinchName(i), WinchLine(move, i), {Polyline()}});
    curves.rates.push_back({WinchName(i), WinchLine(move, i), {}});
  }
  PlotSeries speed{"robot", kSpeedLine, {}};
  for (std::size_t k = 0; k < move.pieces.size(); ++k) {
    std::vector<Polyline> parts(winches + 1);
    for (const double distance : DistancesOf(move, move.pieces[k])) {
      const MoveSample sample = SampleAt(move, k, distance);
      for (std::size_t i = 0; i < winches; ++i) {
        curves.lengths[i].parts[0].push_back({sample.t_s, sample.lengths[i]});
        parts[i].push_back({sample.t_s, sample.rates[i]});
      }
      parts[winches].push_back({sample.t_s, sample.speed});
    }
    for (std::size_t i = 0; i < winches; ++i) curves.rates[i].parts.push_back(std::move(parts[i]));
    speed.parts.push_back(std::move(parts[winches]));
  }
  for (const CornerSwitch& s : move.switches) {
    const MoveSample sample = SampleAt(move, s.piece, s.distance_m);
    curves.lengths[s.anchor].dots.push_back({s.t_s, sample.lengths[s.anchor]});
    curves.rates[s.anchor].dots.push_back({s.t_s, sample.rates[s.anchor]});
  }
  curves.rates.insert(curves.rates.begin(), std::move(speed));
  return curves;
}

std::vector<PlotContent> Plots(const Move& move, const MoveOptions& options) {
  Curves curves = DrawnCurves(move);
  std::vector<PlotEvent> turns;
  for (std::size_t k = 1; k < move.pieces.size(); ++k) turns.push_back({move.pieces[k].begin_s, "turn"});
  std::vector<PlotLevel> levels;
  if (options.winch_limits.size() == 1) {
    levels = {{-options.winch_limits[0], "limit"}, {options.winch_limits[0], "limit"}};
  }
  return {{.title = "Cable lengths",
           .x_label = "time (s)",
           .y_label = "m",
           .series = std::move(curves.lengths),
           .events = turns},
          {.title = "Cable rates",
           .x_label = "time (s)",
           .y_label = "m/s; above 0 the winch pays out, below it reels in",
           .series = std::move(curves.rates),
           .events = turns,
           .levels = levels,
           .with_zero = true}};
}

std::vector<LegendEntry> MoveLegend(const Move& move, int decimals) {
  std::vector<LegendEntry> legend = {{GroundSwatch{.fill = kWorkspaceFill, .edge = kWorkspaceLine.colour}, "workspace"},
                                     {kPathLine, "robot path " + LengthText(move.path.length, decimals)}};
  const std::size_t last = move.pieces.size() - 1;
  const MoveSample start = SampleAt(move, 0, 0), end = SampleAt(move, last, move.pieces[last].profile.length_m());
  for (std::size_t i = 0; i < start.lengths.size(); ++i) {
    const auto switches =
        std::count_if(move.switches.begin(), move.switches.end(), [i](const CornerSwitch& s) { return s.anchor == i; });
    legend.push_back(
        {WinchLine(move, i),
         "cable of " + WinchName(i) + " at the start",
         {LengthText(start.lengths[i], decimals) + ", at the goal " + LengthText(end.lengths[i], decimals),
          std::to_string(switches) + (switches == 1 ? " switch of its corner" : " switches of its corner")}});
  }
  LineStyle later = WinchLine(move, 0);
  later.width = kLaterCableWidth;
  legend.push_back({later, "the same at later times"});
  if (!move.switches.empty()) legend.push_back({Marker::kPoint, "a cable switches its corner"});
  return legend;
}

void DrawCables(Figure& figure, const Move& move) {
  const auto draw = [&](std::size_t piece, double distance, double width) {
    const std::vector<Polyline> cables = CablesAt(move, piece, distance);
    for (std::size_t i = 0; i < cables.size(); ++i) {
      LineStyle style = WinchLine(move, i);
      style.width = width;
      figure.Line(width == kCableWidth ? "cable" : "later-cable", cables[i], style);
    }
  };
  for (int step = 1; step <= kLaterTimes + 1; ++step) {
    const double at = move.path.length * step / (kLaterTimes + 1);
    std::size_t piece = 0;
    while (piece + 1 < move.pieces.size() && move.pieces[piece + 1].begin_m <= at) ++piece;
    draw(piece, at - move.pieces[piece].begin_m, kLaterCableWidth);
  }
  draw(0, 0, kCableWidth);
}

std::string DrawOutside(const Scene& scene, const FreeSpace& space, const MovePicture& picture,
                        const FigureContent& base) {
  const OutsideFault& fault = picture.move.error();
  const bool start = fault.obstruction == WorkspaceObstruction::kStartOutside;
  FigureContent content = base;
  content.title =
      start ? "No motion: the start is outside of the workspace" : "No motion: the goal is outside of the workspace";
  content.legend = {{GroundSwatch{.fill = kWorkspaceFill, .edge = kWorkspaceLine.colour}, "workspace"},
                    {Marker::kWinch, "winch of a cable"}};
  content.notes = {Sentence(fault.explanation)};
  Figure figure(scene, space, content);
  DrawWorkspaceArea(figure, picture.boundary.ring);
  MarkAnchors(figure, BasesOf(picture.anchors));
  figure.Mark(start ? Marker::kBlocked : Marker::kRobot, picture.start, "start");
  figure.Mark(start ? Marker::kGoal : Marker::kBlocked, picture.goal, "goal");
  return figure.Finish();
}

}  // namespace

std::string DrawMove(const Scene& scene, const FreeSpace& space, const MovePicture& picture) {
  FigureContent content{.shown = WorkspacePoints(scene)};
  content.shown.push_back(picture.start);
  content.shown.push_back(picture.goal);
  if (!picture.move) return DrawOutside(scene, space, picture, content);
  const Move& move = *picture.move;
  const int decimals = LengthDecimals(space);
  content.title = "Robot path " + LengthText(move.path.length, decimals) + " in " + SecondsText(move.duration_s);
  if (move.outside) content.notes = {"The path leaves the workspace beside a winch in the open."};
  content.legend = MoveLegend(move, decimals);
  content.plots = Plots(move, picture.options);
  Figure figure(scene, space, content);
  DrawWorkspaceArea(figure, picture.boundary.ring);
  DrawCables(figure, move);
  figure.Line("robot-path", move.path.points, kPathLine);
  for (const CornerSwitch& s : move.switches) {
    if (move.switches.size() > kMostMarked) break;
    figure.Mark(Marker::kPoint, SampleAt(move, s.piece, s.distance_m).robot);
  }
  MarkAnchors(figure, BasesOf(picture.anchors));
  figure.Mark(Marker::kRobot, picture.start, "robot");
  figure.Mark(Marker::kGoal, picture.goal, "goal");
  return figure.Finish();
}

}  // namespace tautline
