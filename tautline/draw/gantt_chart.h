// Who does what when: a row of bars for each robot over a common axis of time.
#ifndef TAUTLINE_DRAW_GANTT_CHART_H_
#define TAUTLINE_DRAW_GANTT_CHART_H_

#include <string>
#include <vector>

#include "tautline/draw/svg_writer.h"

namespace tautline {

/// A time during which a robot drives or waits.
struct GanttBar {
  double from = 0;     ///< s.
  double to = 0;       ///< s.
  bool waits = false;  ///< Hatched, and lower.
};

/// Something that happens at a moment.
struct GanttMark {
  double at = 0;     ///< s.
  std::string text;  ///< Above the bar, where there is room.
};

/// One row.
struct GanttRow {
  std::string name;              ///< In front of it.
  std::string colour;            ///< Of its bars.
  std::vector<GanttBar> bars;    ///< In order.
  std::vector<GanttMark> marks;  ///< In order.
};

/// A chart in its frame. Deterministic.
class GanttChart {
 public:
  /// Lays out the rows, the times from 0 to `end_s` and the axis in a frame of pixels.
  GanttChart(const Box& frame, std::vector<GanttRow> rows, double end_s);

  /// The height in pixels that suits so many rows.
  static double HeightOf(std::size_t rows);

  /// Draws it. The document must define the hatch.
  void Draw(SvgWriter& svg) const;

  /// A vertical line through all rows at a time, pixels.
  Polyline LineAt(double t_s) const;

 private:
  double X(double t_s) const;
  void DrawAxis(SvgWriter& svg) const;
  void DrawRow(SvgWriter& svg, const GanttRow& row, double middle) const;
  void DrawMarks(SvgWriter& svg, const GanttRow& row, double middle) const;

  Box area_;
  std::vector<GanttRow> rows_;
  double end_s_;
  double row_height_;
};

}  // namespace tautline

#endif  // TAUTLINE_DRAW_GANTT_CHART_H_
