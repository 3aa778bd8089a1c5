// Lines of a picture: cased, dashed, wavy, with arrow heads, or side by side.
#ifndef TAUTLINE_DRAW_CURVE_H_
#define TAUTLINE_DRAW_CURVE_H_

#include <span>
#include <vector>

#include "tautline/draw/line_style.h"
#include "tautline/draw/svg_writer.h"

namespace tautline {

/// Draws a polyline (pixels) in a style. A single point, or nothing, draws nothing.
void DrawCurve(SvgWriter& svg, std::span<const Point> line, const LineStyle& style);

/// A place on a polyline and the way it goes there.
struct CurvePosition {
  Point at;         ///< The point itself.
  Point direction;  ///< Of length 1.
};

/// The place at `distance` along a polyline; both ends are limits. An empty line has (0, 0) alone. O(points).
CurvePosition PositionAlong(std::span<const Point> line, double distance);

/// The part of a polyline from `begin` to `end`, distances along it.
Polyline PartOf(std::span<const Point> line, double begin, double end);

/// Moves polylines (pixels) that share edges apart, so that each can be seen: along a shared edge
/// they run parallel, at most `spacing` apart, in the order in which they are given. Two edges are
/// shared when their ends are equal.
std::vector<Polyline> RunSideBySide(std::span<const Polyline> lines, double spacing);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_CURVE_H_
