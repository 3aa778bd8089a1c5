// Curves over a common axis: a plot with axes, ticks and names beside the curves.
#ifndef TAUTLINE_DRAW_PLOT_H_
#define TAUTLINE_DRAW_PLOT_H_

#include <string>
#include <vector>

#include "tautline/draw/line_style.h"
#include "tautline/draw/svg_writer.h"

namespace tautline {

/// One curve, or several parts of one that jumps between them. Points are (x, y) in the units of the axes.
struct PlotSeries {
  std::string name;              ///< Stands beside its right end; empty: without.
  LineStyle style;               ///< How it is drawn.
  std::vector<Polyline> parts;   ///< From left to right.
  std::vector<Point> dots = {};  ///< Marked on it.
};

/// A value of x at which something happens.
struct PlotEvent {
  double x = 0;      ///< Where.
  std::string text;  ///< Written above, where there is room for it.
};

/// A value of y that matters.
struct PlotLevel {
  double y = 0;      ///< Where.
  std::string text;  ///< Written on it at the left.
};

/// The room between two curves over the same axis, lightly filled.
struct PlotBand {
  Polyline low;        ///< From left to right.
  Polyline high;       ///< Likewise.
  std::string colour;  ///< Of the filling.
};

/// What a plot shows.
struct PlotContent {
  std::string title;                   ///< In bold above it.
  std::string x_label;                 ///< With the unit: "time (s)".
  std::string y_label;                 ///< Likewise.
  std::vector<PlotSeries> series;      ///< Later ones over earlier ones.
  std::vector<PlotBand> bands = {};    ///< Below the series.
  std::vector<PlotEvent> events = {};  ///< As thin vertical lines.
  std::vector<PlotLevel> levels = {};  ///< As thin dashed horizontal lines: limits.
  bool with_zero = false;              ///< The y axis includes 0.
};

/// Draws a plot into `frame` (pixels), title, labels and names included. Names that would cover each other are moved
/// apart. Empty and flat data are widened until they can be shown. Deterministic.
void DrawPlot(SvgWriter& svg, const Box& frame, const PlotContent& content);

/// Round values that divide the range from low to high (low < high) in about `count` steps; all are within it.
std::vector<double> RoundTicks(double low, double high, int count);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_PLOT_H_
