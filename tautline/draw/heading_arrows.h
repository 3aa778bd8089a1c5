// Fields of headings: where to drive next from everywhere.
#ifndef TAUTLINE_DRAW_HEADING_ARROWS_H_
#define TAUTLINE_DRAW_HEADING_ARROWS_H_

#include <vector>

#include "tautline/draw/line_style.h"
#include "tautline/draw/svg_writer.h"
#include "tautline/draw/view.h"

namespace tautline {

/// Headings of the first class of a cell.
inline const LineStyle kHeadingLine = {.colour = "#0b4a8f", .width = 1};
/// Headings of the others.
inline const LineStyle kOtherHeadingLine = {.colour = "#9a9a9a", .width = 0.8};

/// How arrows on a lattice are thinned out until they can be told apart.
struct ArrowLattice {
  int stride = 1;         ///< Every so many columns and rows has one.
  double length_px = 10;  ///< Of an arrow.

  /// For a lattice of this spacing, metres.
  ArrowLattice(double spacing_m, const View& view);
  /// Whether this column and row has an arrow.
  bool Has(int column, int row) const { return column % stride == stride / 2 && row % stride == stride / 2; }
};

/// Adds an open arrow about a point in pixels. The heading is anticlockwise from the x axis, as in the world.
void AppendArrow(Point middle, double heading_rad, double length_px, std::vector<SvgCurve>& curves);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_HEADING_ARROWS_H_
