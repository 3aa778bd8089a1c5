// What pictures of one tethered robot share: its base, robot and goal, the laid cable, words.
#ifndef TAUTLINE_DRAW_TETHER_LAYERS_H_
#define TAUTLINE_DRAW_TETHER_LAYERS_H_

#include <string>
#include <vector>

#include "tautline/draw/figure.h"
#include "tautline/homotopy/taut_path.h"

namespace tautline {

/// The points of the scene's tether and its goal: what a map of it should hold.
std::vector<Point> TetherPoints(const Scene& scene);

/// Where the robot stands: the end of the laid cable, or the base.
Point RobotPosition(const Tether& tether);

/// Marks base, robot and goal, as far as the scene has them.
void MarkTether(Figure& figure, const Scene& scene);

/// Draws the laid cable, if any.
void DrawLaid(Figure& figure, const Scene& scene);

/// Appends the laid cable's entry, if any.
void AppendLaidEntry(const Scene& scene, int decimals, std::vector<LegendEntry>& legend);

/// Draws a tether that is `limit` metres long at most: in `style` as far as it reaches, forbidden
/// beyond, with a cross where it ends.
void DrawLimitedTether(Figure& figure, const TautPath& tether, double limit, const LineStyle& style);

/// "word: a b^-1", or "empty word".
std::string WordText(const Word& word, const FreeSpace& space);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_TETHER_LAYERS_H_
