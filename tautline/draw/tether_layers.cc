#include "tautline/draw/tether_layers.h"

#include "tautline/draw/curve.h"
#include "tautline/draw/length_text.h"

namespace tautline {

std::vector<Point> TetherPoints(const Scene& scene) {
  std::vector<Point> points;
  if (scene.tether) {
    points.push_back(scene.tether->base);
    if (scene.tether->laid) points.insert(points.end(), scene.tether->laid->begin(), scene.tether->laid->end());
  }
  if (scene.goal) points.push_back(*scene.goal);
  return points;
}

Point RobotPosition(const Tether& tether) {
  return tether.laid && !tether.laid->empty() ? tether.laid->back() : tether.base;
}

void MarkTether(Figure& figure, const Scene& scene) {
  constexpr double kSamePlace = 4;  // Pixels.
  if (scene.tether) {
    const Point base = scene.tether->base, robot = RobotPosition(*scene.tether);
    const bool together = Distance(base, robot) * figure.view().pixels_per_metre() < kSamePlace;
    figure.Mark(Marker::kBase, base, together ? "base, robot" : "base");
    if (!together) figure.Mark(Marker::kRobot, robot, "robot");
  }
  if (scene.goal) figure.Mark(Marker::kGoal, *scene.goal, "goal");
}

void DrawLaid(Figure& figure, const Scene& scene) {
  if (scene.tether && scene.tether->laid) figure.Line("laid-cable", *scene.tether->laid, kLaidLine);
}

void AppendLaidEntry(const Scene& scene, int decimals, std::vector<LegendEntry>& legend) {
  if (!scene.tether || !scene.tether->laid) return;
  legend.push_back({kLaidLine, "cable as laid " + LengthText(Length(*scene.tether->laid), decimals)});
}

void DrawLimitedTether(Figure& figure, const TautPath& tether, double limit, const LineStyle& style) {
  figure.Line("tether", PartOf(tether.points, 0, limit), style);
  if (tether.length <= limit) return;
  figure.Line("beyond-limit", PartOf(tether.points, limit, Length(tether.points)), kForbiddenLine);
  figure.Mark(Marker::kTetherEnd, PositionAlong(tether.points, limit).at, "the tether ends here");
}

std::string WordText(const Word& word, const FreeSpace& space) {
  if (word.empty()) return "empty word";
  std::string text = "word:";
  for (const Letter letter : word.letters()) text += " " + space.name(letter.obstacle) + (letter.inverse ? "^-1" : "");
  return text;
}

}  // namespace tautline
