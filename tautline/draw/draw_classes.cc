#include "tautline/draw/draw_classes.h"

#include <algorithm>

#include "tautline/draw/length_text.h"
#include "tautline/draw/numbered_lines.h"
#include "tautline/draw/obstacle_names.h"
#include "tautline/draw/tether_layers.h"

namespace tautline {
namespace {

/// Enough decimals to tell neighbouring lengths of the numbered lines apart, unless they differ by
/// rounding alone.
int EnoughDecimals(const FreeSpace& space, const std::vector<TautPath>& classes) {
  int decimals = LengthDecimals(space);
  for (std::size_t i = 1; i < std::min(classes.size(), kMostNumberedLines); ++i) {
    const int apart = DecimalsToTellApart(classes[i - 1].length, classes[i].length, decimals);
    if (apart <= LengthDecimals(space) + 2) decimals = apart;
  }
  return decimals;
}

std::string Title(const ClassList& list, int decimals) {
  if (list.classes.empty()) return "No class: no way between the two points";
  const std::string count = std::to_string(list.classes.size());
  const std::string noun = list.classes.size() == 1 ? " homotopy class" : " homotopy classes";
  const std::string shortest = LengthText(list.classes.front().length, decimals);
  if (list.classes.size() == 1) return count + noun + ", " + shortest;
  return count + noun + ", from " + shortest + " to " + LengthText(list.classes.back().length, decimals);
}

std::vector<std::string> Notes(const ClassList& list) {
  if (list.budget_exceeded) return {"The search stopped at its budget; longer classes are missing."};
  if (list.complete) return {"No class up to the largest length asked for is missing."};
  return {"There are more, longer classes."};
}

std::vector<NumberedLine> Lines(const FreeSpace& space, const ClassList& list, int decimals) {
  std::vector<NumberedLine> lines;
  for (const TautPath& path : list.classes) {
    const int number = static_cast<int>(lines.size()) + 1;
    lines.push_back({.points = path.points,
                     .number = number,
                     .text = LengthText(path.length, decimals),
                     .details = {WordText(path.word, space)}});
  }
  return lines;
}

/// The letters of the numbered classes.
std::set<ObstacleId> Letters(const ClassList& list) {
  std::set<ObstacleId> letters;
  for (std::size_t i = 0; i < std::min(list.classes.size(), kMostNumberedLines); ++i) {
    letters.merge(IslandsOf(list.classes[i].word));
  }
  return letters;
}

void MarkEnds(Figure& figure, const Scene& scene, const ClassesPicture& picture) {
  const bool at_base = scene.tether && scene.tether->base == picture.from;
  const bool at_goal = scene.goal && *scene.goal == picture.to;
  figure.Mark(at_base ? Marker::kBase : Marker::kPoint, picture.from, at_base ? "base" : "from");
  figure.Mark(at_goal ? Marker::kGoal : Marker::kPoint, picture.to, at_goal ? "goal" : "to");
}

}  // namespace

std::string DrawClasses(const Scene& scene, const FreeSpace& space, const ClassesPicture& picture) {
  const int decimals = EnoughDecimals(space, picture.list.classes);
  const std::vector<NumberedLine> lines = Lines(space, picture.list, decimals);
  std::vector<LegendEntry> legend;
  AppendNumberedEntries(lines, legend);
  Figure figure(scene, space,
                {.title = Title(picture.list, decimals),
                 .notes = Notes(picture.list),
                 .legend = std::move(legend),
                 .shown = {picture.from, picture.to}});
  DrawNumberedLines(figure, lines);
  figure.Name(Letters(picture.list));
  MarkEnds(figure, scene, picture);
  return figure.Finish();
}

}  // namespace tautline
