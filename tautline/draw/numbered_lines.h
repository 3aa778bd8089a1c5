// Several classes in one picture, numbered by length.
#ifndef TAUTLINE_DRAW_NUMBERED_LINES_H_
#define TAUTLINE_DRAW_NUMBERED_LINES_H_

#include <span>
#include <string>
#include <vector>

#include "tautline/draw/figure.h"

namespace tautline {

/// A line of a picture that the legend tells more about.
struct NumberedLine {
  Polyline points;                   ///< Metres.
  int number = 1;                    ///< Shown on the line and in the legend.
  std::string text;                  ///< For the legend.
  std::vector<std::string> details;  ///< For the legend.
};

inline constexpr std::size_t kMostNumberedLines = 12;  ///< Later ones are thin and grey.
inline constexpr std::size_t kMostThinLines = 60;      ///< Later ones are not drawn.

/// Draws the lines, the first of them on top, side by side where they share edges.
void DrawNumberedLines(Figure& figure, std::span<const NumberedLine> lines);

/// Appends the entries of the numbered lines, and one for the rest.
void AppendNumberedEntries(std::span<const NumberedLine> lines, std::vector<LegendEntry>& legend);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_NUMBERED_LINES_H_
