#include "tautline/draw/draw_reference.h"

#include <utility>

#include "tautline/draw/length_text.h"
#include "tautline/draw/numbered_lines.h"
#include "tautline/draw/obstacle_names.h"
#include "tautline/draw/tether_layers.h"

namespace tautline {
namespace {

/// The path on the lattice, and that along the Voronoi diagram.
const LineStyle kDijkstraLine = {.colour = "#00684c", .width = 1.8, .dashes = "6 3"};
const LineStyle kVoronoiLine = {.colour = "#7a2f8f", .width = 1.8, .dashes = "2 2"};

const LineStyle& StyleOf(const BaselinePath& baseline) {
  return baseline.method == "voronoi" ? kVoronoiLine : kDijkstraLine;
}

/// What the parts of the picture look up.
struct Case {
  const Scene& scene;
  const FreeSpace& space;
  const ReferencePicture& picture;
  int decimals;

  std::string Metres(double length) const { return LengthText(length, decimals); }
};

std::string Title(const Case& c) {
  const ReferenceSelection& selection = c.picture.selection;
  if (const auto& reference = selection.reference) {
    return "Reference path " + c.Metres(reference->length_m) + "; at the goal the tether takes " +
           c.Metres(reference->tether_length_m) + " of " + c.Metres(c.scene.tether->length);
  }
  return selection.outcome == ReferenceOutcome::kBudgetExceeded ? "The search stopped before it had an answer"
                                                                : "No reference path";
}

/// How many of the classes that the engine lists the paper's way has found.
std::string YenNote(const ReferenceSelection& exact, const ReferenceSelection& yen) {
  std::size_t both = 0;
  for (const ReferenceCandidate& a : exact.candidates) {
    for (const ReferenceCandidate& b : yen.candidates) both += a.path.word == b.path.word ? 1 : 0;
  }
  return "Yen's paths: " + std::to_string(both) + " of these " + std::to_string(exact.candidates.size()) +
         " classes, " + std::to_string(yen.candidates.size()) + " in all.";
}

std::vector<std::string> Notes(const Case& c) {
  std::vector<std::string> notes;
  const ReferencePicture& picture = c.picture;
  if (!picture.selection.explanation.empty()) notes.push_back(picture.selection.explanation);
  if (picture.yen) notes.push_back(YenNote(picture.selection, *picture.yen));
  return notes;
}

std::vector<NumberedLine> Lines(const Case& c) {
  std::vector<NumberedLine> lines;
  for (const ReferenceCandidate& candidate : c.picture.selection.candidates) {
    const int number = static_cast<int>(lines.size()) + 1;
    lines.push_back({.points = candidate.path.points,
                     .number = number,
                     .text = c.Metres(candidate.path.length) + ", tether " + c.Metres(candidate.tether->length) +
                             (candidate.fits ? "" : ", too long"),
                     .details = {WordText(candidate.path.word, c.space)}});
  }
  return lines;
}

std::vector<LegendEntry> MakeLegend(const Case& c, const std::vector<NumberedLine>& lines) {
  std::vector<LegendEntry> legend;
  if (const auto& reference = c.picture.selection.reference) {
    legend.push_back(
        {kPathLine, "reference path " + c.Metres(reference->length_m), {WordText(reference->word, c.space)}});
  }
  for (const BaselinePath& baseline : c.picture.baselines) {
    const std::string way = baseline.method == "voronoi" ? "along the Voronoi diagram " : "on the lattice ";
    legend.push_back({StyleOf(baseline), way + c.Metres(Length(baseline.path))});
  }
  if (c.picture.selection.shortest_tether) {
    legend.push_back(
        {kGoalTetherLine, "least tether to the goal " + c.Metres(c.picture.selection.shortest_tether->length)});
  }
  AppendLaidEntry(c.scene, c.decimals, legend);
  // With baselines to look at, the other classes would be in the way.
  if (c.picture.baselines.empty()) AppendNumberedEntries(lines, legend);
  return legend;
}

}  // namespace

std::string DrawReference(const Scene& scene, const FreeSpace& space, const ReferencePicture& picture) {
  // The robot's size is part of the ground that is drawn.
  Scene grown = scene;
  grown.world.clearance = space.clearance;
  const Case c{grown, space, picture, LengthDecimals(space)};
  const std::vector<NumberedLine> lines = Lines(c);
  Figure figure(grown, space,
                {.title = Title(c), .notes = Notes(c), .legend = MakeLegend(c, lines), .shown = TetherPoints(grown)});
  if (picture.selection.shortest_tether) {
    DrawLimitedTether(figure, *picture.selection.shortest_tether, scene.tether->length, kGoalTetherLine);
  }
  if (picture.baselines.empty()) DrawNumberedLines(figure, lines);
  for (const BaselinePath& baseline : picture.baselines) figure.Line(baseline.method, baseline.path, StyleOf(baseline));
  if (picture.selection.reference) {
    figure.Line("robot-path", picture.selection.reference->path, kPathLine);
    figure.Name(IslandsOf(picture.selection.reference->word));
  }
  DrawLaid(figure, grown);
  MarkTether(figure, grown);
  return figure.Finish();
}

}  // namespace tautline
