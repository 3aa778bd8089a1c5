#include "tautline/draw/draw_untangling.h"

#include <algorithm>

#include "tautline/draw/cell_shapes.h"
#include "tautline/draw/figure.h"
#include "tautline/draw/length_text.h"

namespace tautline {
namespace {

/// Candidates with a number and what comes of them, those with the largest scores; more only cover each other.
constexpr std::size_t kMostNumbered = 12;
constexpr char kRegionColour[] = "#cfe3f5";
const LineStyle kCableNowLine = {.colour = "#8f6400", .width = 2.6};
const LineStyle kTrialLine = {.colour = "#8a94a0", .width = 1, .dashes = "4 3"};
const LineStyle kChosenLine = {.colour = "#0b7a3c", .width = 2.2};
const LineStyle kAfterLine = {.colour = "#0b7a3c", .width = 1};

std::string CellsText(std::size_t cells) { return std::to_string(cells) + (cells == 1 ? " vertex" : " vertices"); }

/// "Driving to 1 clears the way, to 2 leaves 95 vertices, to 3 ...".
std::string OutcomesText(const TargetTrials& trials) {
  std::string text = "Driving to";
  for (std::size_t i = 0; i < std::min(kMostNumbered, trials.targets.size()); ++i) {
    const TriedTarget& target = trials.targets[i];
    text += (i == 0 ? " " : ", to ") + std::to_string(i + 1) +
            (target.clears    ? " clears the way"
             : target.touched ? " pulls the cable under the robot"
                              : " leaves " + CellsText(target.region.size()));
  }
  return text + ".";
}

std::string TitleOf(const TargetTrials& trials) {
  if (trials.targets.empty()) return "No candidates: the robot can go nowhere";
  const std::string count =
      std::to_string(trials.targets.size()) + (trials.targets.size() == 1 ? " candidate" : " candidates");
  if (trials.open) return count + "; but the way to the goal is open already";
  if (!trials.chosen) return count + ", none to choose";
  return count + "; number " + std::to_string(*trials.chosen + 1) +
         (trials.targets[*trials.chosen].clears ? " clears the way" : " leaves the most ground");
}

FigureContent ContentOf(const TargetTrials& trials) {
  FigureContent content{.title = TitleOf(trials)};
  content.notes.emplace_back("Their scores: the lesser of the ways to the robot and to the centre of its ground.");
  if (!trials.targets.empty()) content.notes.push_back(OutcomesText(trials));
  if (trials.targets.size() > kMostNumbered) {
    content.notes.push_back("Of the other " + std::to_string(trials.targets.size() - kMostNumbered) +
                            ", which score less, the places are shown.");
  }
  content.legend = {{GroundSwatch{.fill = kRegionColour}, "where the robot can go: " + CellsText(trials.region.size())},
                    {kCableNowLine, "the cable"},
                    {kTrialLine, "the cable after each trial"}};
  if (trials.chosen) {
    content.legend.push_back({kChosenLine, "after the chosen one"});
    content.legend.push_back({kAfterLine, "where the robot can go then"});
  }
  return content;
}

std::vector<SvgCurve> CurvesOf(const OccupancyGrid& grid, const RegionCells& cells, const View& view) {
  std::vector<bool> marked(grid.cells.size());
  for (const GridCell cell : cells) marked[grid.index(cell.column, cell.row)] = true;
  return CellCurves(grid, marked, view);
}

}  // namespace

std::string DrawUntangling(const Scene& scene, const OccupancyGrid& grid, const TargetTrials& trials) {
  const auto space = BuildFreeSpace(scene.world);
  if (!space) return "";
  Figure figure(scene, *space, ContentOf(trials));
  figure.Shape("region", CurvesOf(grid, trials.region, figure.view()), {.fill = kRegionColour});
  for (const TriedTarget& target : trials.targets) figure.Line("trials", target.cable, kTrialLine);
  if (trials.chosen) {
    const TriedTarget& chosen = trials.targets[*trials.chosen];
    figure.Shape("after", CurvesOf(grid, chosen.region, figure.view()),
                 {.stroke = kAfterLine.colour, .width = kAfterLine.width});
    figure.Line("chosen", chosen.cable, kChosenLine);
  }
  figure.Line("cable", trials.cable, kCableNowLine);
  for (std::size_t i = 0; i < trials.targets.size(); ++i) {
    const bool numbered = i < kMostNumbered || trials.chosen == i;
    figure.Mark(trials.chosen == i ? Marker::kStar : Marker::kPoint, trials.targets[i].at,
                numbered ? std::to_string(i + 1) + ": " + FixedText(trials.targets[i].score_m, 2) + " m" : "");
  }
  figure.Mark(Marker::kBase, scene.tether->base, "base");
  figure.Mark(Marker::kRobot, trials.robot, "robot");
  figure.Mark(Marker::kGoal, trials.goal, "goal");
  return figure.Finish();
}

}  // namespace tautline
