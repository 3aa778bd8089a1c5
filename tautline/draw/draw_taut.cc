#include "tautline/draw/draw_taut.h"

#include <algorithm>

#include "tautline/draw/length_text.h"
#include "tautline/draw/obstacle_names.h"
#include "tautline/draw/tether_layers.h"

namespace tautline {
namespace {

std::vector<std::string> Notes(const Scene& scene, const TautPicture& picture, int decimals) {
  if (!scene.tether || !(scene.tether->length > 0)) return {};
  const double limit = scene.tether->length;
  decimals = DecimalsToTellApart(picture.taut.length, limit, decimals);
  const std::string text = "the tether, " + LengthText(limit, decimals);
  return {picture.taut.length > limit ? "That is longer than " + text + "." : "That is within " + text + "."};
}

std::vector<LegendEntry> TautLegend(const FreeSpace& space, const TautPicture& picture, int decimals) {
  std::vector<LegendEntry> legend = {
      {kLaidLine, "cable as laid " + LengthText(Length(picture.laid), decimals)},
      {kTautLine, "pulled tight " + LengthText(picture.taut.length, decimals), {WordText(picture.taut.word, space)}}};
  if (!picture.taut.word.empty()) {
    legend.push_back({kRayLine, "ray of an obstacle", {"crossing it to the right writes its name"}});
  }
  return legend;
}

void MarkEnds(Figure& figure, const Scene& scene, const Polyline& laid) {
  if (laid.empty()) return;
  const bool at_base = !scene.tether || scene.tether->base == laid.front();
  figure.Mark(Marker::kBase, laid.front(), at_base ? "base" : "from");
  if (laid.back() != laid.front()) figure.Mark(Marker::kRobot, laid.back(), "robot");
}

}  // namespace

std::string DrawTaut(const Scene& scene, const FreeSpace& space, const TautPicture& picture) {
  const int decimals = DecimalsToTellApart(picture.taut.length, Length(picture.laid), LengthDecimals(space));
  const int shown = std::min(decimals, LengthDecimals(space) + 3);
  Figure figure(scene, space,
                {.title = "Pulled tight, the cable takes " + LengthText(picture.taut.length, shown) + " of " +
                          LengthText(Length(picture.laid), shown) + " laid",
                 .notes = Notes(scene, picture, shown),
                 .legend = TautLegend(space, picture, shown),
                 .shown = picture.laid});
  const std::set<ObstacleId> letters = IslandsOf(picture.taut.word);
  figure.Rays(letters);
  figure.Line("taut", picture.taut.points, kTautLine);
  figure.Line("laid-cable", picture.laid, kLaidLine);
  figure.Name(letters);
  MarkEnds(figure, scene, picture.laid);
  return figure.Finish();
}

}  // namespace tautline
