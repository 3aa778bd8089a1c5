#include "tautline/draw/draw_reach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "tautline/draw/length_text.h"
#include "tautline/draw/obstacle_names.h"
#include "tautline/draw/tether_layers.h"

namespace tautline {
namespace {

/// More sheets than this lie too densely to be told apart, and make files that no viewer likes.
constexpr std::size_t kMostSheets = 1'500;
constexpr std::size_t kMostPieces = 60'000;
constexpr double kMostOnAverage = 30;
/// Sheets whose ends are drawn as lines, and rays.
constexpr std::size_t kMostOutlined = 40;
constexpr std::size_t kMostRays = 12;
/// How dark ground within reach is, before its classes darken it, and what they add where they are as many as at a
/// point on average.
constexpr double kPlainOpacity = 0.17;
constexpr double kUnderOpacity = 0.08;
constexpr double kAverageOpacity = 0.45;
/// An arc is drawn in steps of at most a third of a turn, so that each has one meaning in SVG.
constexpr double kLongestStep = 2 * std::numbers::pi / 3;

/// What the parts of the picture look up.
struct Case {
  const Scene& scene;
  const FreeSpace& space;
  const ReachResult& result;
  int decimals = 2;

  std::string Metres(double length) const { return LengthText(length, decimals); }
};

double ClassesOnAverage(const ReachResult& result) {
  return result.area > 0 ? std::max(1.0, result.sheets->area / result.area) : 1;
}

bool ShowsSheets(const ReachResult& result) {
  if (!result.sheets || !result.sheets->complete) return false;
  std::size_t pieces = 0;
  for (const Sheet& sheet : result.sheets->sheets) {
    for (const RegionRing& ring : sheet.rings) pieces += ring.pieces.size();
  }
  return result.sheets->sheets.size() <= kMostSheets && pieces <= kMostPieces &&
         ClassesOnAverage(result) <= kMostOnAverage;
}

/// Whether some ground is reached in several classes.
bool ShowsOverlaps(const ReachResult& result) { return ShowsSheets(result) && ClassesOnAverage(result) > 1.0001; }

/// The opacity of one sheet.
double SheetOpacity(const ReachResult& result) {
  return std::min(0.6 * kPlainOpacity, 1 - std::pow(1 - kAverageOpacity, 1 / ClassesOnAverage(result)));
}

/// The colour of so many sheets over a first layer on white.
std::string Shade(double under, double opacity, int sheets) {
  constexpr std::array<int, 3> kInk = {0x0b, 0x4a, 0x8f};  // That of kReachLine.
  const double rest = (1 - under) * std::pow(1 - opacity, sheets);
  std::array<char, 8> text{};
  const auto mix = [rest](int ink) { return static_cast<int>(std::lround(rest * 255 + (1 - rest) * ink)); };
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", mix(kInk[0]), mix(kInk[1]), mix(kInk[2]));
  return text.data();
}

void AppendSteps(const View& view, const RegionPiece& piece, SvgCurve& curve) {
  if (!piece.is_arc()) {
    curve.steps.push_back({.to = view.ToPixels(piece.to)});
    return;
  }
  const Point start = piece.from - piece.centre;
  const double low = std::atan2(start.y, start.x), radius = piece.radius * view.pixels_per_metre();
  const int count = std::max(1, static_cast<int>(std::ceil(piece.sweep / kLongestStep)));
  for (int i = 1; i <= count; ++i) {
    const double angle = low + piece.sweep * i / count;
    const Point to = i == count ? piece.to : piece.centre + piece.radius * Point{std::cos(angle), std::sin(angle)};
    curve.steps.push_back({view.ToPixels(to), radius, true});
  }
}

std::vector<SvgCurve> CurvesOf(const View& view, const std::vector<RegionRing>& rings) {
  std::vector<SvgCurve> curves;
  for (const RegionRing& ring : rings) {
    SvgCurve curve{.start = view.ToPixels(ring.pieces[0].from), .steps = {}, .closed = true};
    for (const RegionPiece& piece : ring.pieces) AppendSteps(view, piece, curve);
    curves.push_back(std::move(curve));
  }
  return curves;
}

/// The arcs alone; those that follow each other as one curve.
std::vector<SvgCurve> ArcsOf(const View& view, const std::vector<RegionRing>& rings) {
  std::vector<SvgCurve> curves;
  for (const RegionRing& ring : rings) {
    bool goes_on = false;
    for (const RegionPiece& piece : ring.pieces) {
      if (piece.is_arc()) {
        if (!goes_on) curves.push_back({.start = view.ToPixels(piece.from), .steps = {}});
        AppendSteps(view, piece, curves.back());
      }
      goes_on = piece.is_arc();
    }
  }
  return curves;
}

std::string Share(double part, double whole) {
  const double percent = whole > 0 ? 100 * part / whole : 0;
  const double shown = percent < 99.95 ? std::min(percent, 99.9) : percent > 99.9999 ? 100 : 99.9;
  return CompactText(shown, 1) + " %";
}

std::string Title(const Case& c) {
  const ReachResult& result = c.result;
  if (result.obstruction == PlanObstruction::kStartBlocked) return "No reach: the base lies on blocked ground";
  if (result.status == PlanStatus::kInfeasible) return "No reach: the tether ends inside its socket";
  return "A tether of " + c.Metres(result.limit) + " reaches " + AreaText(result.area) + ", " +
         Share(result.area, result.connected_area) + " of the connected ground";
}

std::vector<std::string> Notes(const Case& c) {
  const ReachResult& result = c.result;
  std::vector<std::string> notes;
  if (!result.explanation.empty()) notes.push_back(result.explanation);
  if (result.sheets && result.sheets->complete) {
    const std::size_t count = result.sheets->sheets.size();
    notes.push_back("It can lie in " + std::to_string(count) + (count == 1 ? " class" : " classes") + "; " +
                    CompactText(ClassesOnAverage(result), 1) + " of them reach a point, on average.");
    if (!ShowsSheets(result)) notes.emplace_back("Too many to draw.");
  }
  if (result.at && !result.at->explanation.empty()) notes.push_back(result.at->explanation);
  return notes;
}

void AppendGroundEntries(const Case& c, std::vector<LegendEntry>& legend) {
  const ReachResult& result = c.result;
  const auto patch = [&](const std::string& fill, const std::string& text) {
    legend.push_back({GroundSwatch{.fill = fill, .edge = kClearanceLineColour}, text, {}});
  };
  if (!ShowsOverlaps(result)) {
    patch(Shade(kPlainOpacity, 0, 0), "within reach");
  } else {
    const double opacity = SheetOpacity(result);
    patch(Shade(kUnderOpacity, opacity, 1), "within reach in 1 class");
    const double most =
        std::min<double>(2.5 * ClassesOnAverage(result), static_cast<double>(result.sheets->sheets.size()));
    for (const int count : {2, 5, 10, 20, 50, 100}) {
      if (count <= most) patch(Shade(kUnderOpacity, opacity, count), "in " + std::to_string(count) + " classes");
    }
  }
  double free = 0;
  for (const FreeComponent& component : c.space.components) free += component.area;
  if (result.area < 0.9999 * free) {
    legend.push_back({GroundSwatch{.fill = kFreeColour, .edge = kClearanceLineColour}, "out of reach", {}});
  }
}

std::set<ObstacleId> LettersOf(const SheetList& list) {
  std::set<ObstacleId> letters;
  for (const Sheet& sheet : list.sheets) letters.merge(IslandsOf(sheet.word));
  return letters;
}

bool ShowsRays(const ReachResult& result) {
  return ShowsSheets(result) && !LettersOf(*result.sheets).empty() && LettersOf(*result.sheets).size() <= kMostRays;
}

bool ShowsSheetEnds(const ReachResult& result) {
  return ShowsOverlaps(result) && result.sheets->sheets.size() <= kMostOutlined;
}

std::vector<LegendEntry> ReachLegend(const Case& c) {
  const ReachResult& result = c.result;
  std::vector<LegendEntry> legend;
  if (result.status == PlanStatus::kInfeasible) return legend;
  AppendGroundEntries(c, legend);
  if (result.stretched) legend.push_back({kReachLine, "where the tether ends"});
  if (ShowsSheetEnds(result)) legend.push_back({kSheetLine, "where it ends in some class"});
  if (ShowsRays(result)) legend.push_back({kRayLine, "ray of an obstacle", {"across it the class has another name"}});
  if (result.at && result.at->least_tether) {
    const TautPath& tether = *result.at->least_tether;
    legend.push_back({kStartTetherLine,
                      "least tether to the point " + c.Metres(tether.length),
                      {"limit " + c.Metres(result.limit), WordText(tether.word, c.space)}});
    if (tether.length > result.limit) {
      legend.push_back({kForbiddenLine, "beyond the limit " + c.Metres(tether.length - result.limit)});
    }
  } else if (result.stretched && !result.at) {
    legend.push_back({kStartTetherLine,
                      "a tether fully out, " + c.Metres(result.stretched->length),
                      {WordText(result.stretched->word, c.space)}});
  }
  return legend;
}

void DrawRegion(Figure& figure, const Case& c) {
  const ReachResult& result = c.result;
  const View& view = figure.view();
  const std::string ink = kReachLine.colour;
  const bool sheets = ShowsOverlaps(result);
  figure.Shape("region", CurvesOf(view, result.regions),
               {.fill = ink, .opacity = sheets ? kUnderOpacity : kPlainOpacity});
  if (sheets) {
    for (const Sheet& sheet : result.sheets->sheets) {
      figure.Shape("sheet", CurvesOf(view, sheet.rings), {.fill = ink, .opacity = SheetOpacity(result)});
    }
  }
  if (ShowsSheetEnds(result)) {
    for (const Sheet& sheet : result.sheets->sheets) {
      figure.Shape("sheet-end", ArcsOf(view, sheet.rings),
                   {.stroke = ink, .width = kSheetLine.width, .dashes = kSheetLine.dashes});
    }
  }
  if (ShowsRays(result)) figure.Rays(LettersOf(*result.sheets));
  figure.Shape("reach-end", ArcsOf(view, result.regions), {.stroke = ink, .width = kReachLine.width});
}

void DrawTether(Figure& figure, const Case& c) {
  const ReachResult& result = c.result;
  if (!result.at) {
    if (result.stretched) figure.Line("tether", result.stretched->points, kStartTetherLine);
    return;
  }
  if (result.at->least_tether) DrawLimitedTether(figure, *result.at->least_tether, result.limit, kStartTetherLine);
  const bool blocked = result.at->obstruction == PlanObstruction::kGoalBlocked;
  figure.Mark(blocked ? Marker::kBlocked : Marker::kPoint, result.at->point, "point");
}

}  // namespace

std::string DrawReach(const Scene& scene, const FreeSpace& space, const ReachResult& result) {
  const Case c{scene, space, result, LengthDecimals(space)};
  std::vector<Point> shown;
  if (scene.tether) shown.push_back(scene.tether->base);
  if (result.at) shown.push_back(result.at->point);
  Figure figure(scene, space, {.title = Title(c), .notes = Notes(c), .legend = ReachLegend(c), .shown = shown});
  if (result.status != PlanStatus::kInfeasible) {
    DrawRegion(figure, c);
    DrawTether(figure, c);
  }
  if (ShowsRays(result)) figure.Name(LettersOf(*result.sheets));
  if (scene.tether) {
    const bool blocked = result.obstruction == PlanObstruction::kStartBlocked;
    figure.Mark(blocked ? Marker::kBlocked : Marker::kBase, scene.tether->base, "base");
  }
  return figure.Finish();
}

}  // namespace tautline
