#include "tautline/draw/gantt_chart.h"

#include <algorithm>

#include "tautline/draw/length_text.h"
#include "tautline/draw/line_style.h"
#include "tautline/draw/plot.h"
#include "tautline/draw/text_metrics.h"

namespace tautline {
namespace {

constexpr double kTallestRow = 30;
constexpr double kLowestRow = 11;
constexpr double kFooter = 36;
constexpr double kNameSize = 11.5;
constexpr double kMostNameWidth = 110;
constexpr double kMarkSize = 10;
constexpr double kTickSize = 11;
constexpr std::size_t kTallRows = 12;
constexpr char kGridColour[] = "#e3e6e9";

}  // namespace

double GanttChart::HeightOf(std::size_t rows) {
  const auto count = static_cast<double>(std::max<std::size_t>(rows, 1));
  return kFooter + count * (rows <= kTallRows ? kTallestRow : std::max(kLowestRow, kTallestRow * kTallRows / count));
}

GanttChart::GanttChart(const Box& frame, std::vector<GanttRow> rows, double end_s)
    : rows_(std::move(rows)), end_s_(end_s > 0 ? end_s : 1) {
  double names = 0;
  for (const GanttRow& row : rows_) names = std::max(names, TextWidth(row.name, kNameSize));
  area_ = {{frame.low.x + std::min(names, kMostNameWidth) + 10, frame.low.y},
           {frame.high.x - 12, frame.high.y - kFooter}};
  row_height_ = area_.size().y / static_cast<double>(std::max<std::size_t>(rows_.size(), 1));
}

double GanttChart::X(double t_s) const { return area_.low.x + t_s / end_s_ * area_.size().x; }

Polyline GanttChart::LineAt(double t_s) const { return {{X(t_s), area_.low.y}, {X(t_s), area_.high.y + 3}}; }

void GanttChart::Draw(SvgWriter& svg) const {
  svg.OpenGroup("schedule");
  DrawAxis(svg);
  double middle = area_.low.y + 0.5 * row_height_;
  for (const GanttRow& row : rows_) {
    DrawRow(svg, row, middle);
    middle += row_height_;
  }
  svg.CloseGroup();
}

void GanttChart::DrawAxis(SvgWriter& svg) const {
  const std::vector<double> ticks = RoundTicks(0, end_s_, 10);
  const int decimals = ticks.size() > 1 && ticks[1] - ticks[0] < 1 ? 3 : 1;
  for (const double tick : ticks) {
    svg.Polyline(LineAt(tick), {.stroke = kGridColour, .width = 0.9});
    svg.Text({.at = {X(tick), area_.high.y + 15},
              .text = CompactText(tick, decimals),
              .size = kTickSize,
              .anchor = TextAnchor::kMiddle});
  }
  svg.Polyline(Polyline{{area_.low.x, area_.high.y}, area_.high}, {.stroke = kInkColour, .width = 1.1});
  svg.Text({.at = {area_.high.x, area_.high.y + 30}, .text = "time (s)", .size = 12, .anchor = TextAnchor::kEnd});
}

void GanttChart::DrawRow(SvgWriter& svg, const GanttRow& row, double middle) const {
  if (row_height_ >= 0.8 * kNameSize) {
    svg.Text({.at = {area_.low.x - 7, middle + 0.36 * kNameSize},
              .text = Ellipsize(row.name, kNameSize, kMostNameWidth),
              .size = std::min(kNameSize, row_height_),
              .anchor = TextAnchor::kEnd});
  }
  for (const GanttBar& bar : row.bars) {
    if (!(bar.to > bar.from)) continue;
    const double half = row_height_ * (bar.waits ? 0.14 : 0.22);
    const Box box{{X(bar.from), middle - half}, {X(bar.to), middle + half}};
    if (bar.waits) {
      svg.Rectangle(box, {.fill = kHatchFill, .stroke = kBoundaryColour, .width = 0.6});
    } else {
      svg.Rectangle(box, {.fill = row.colour});
    }
  }
  DrawMarks(svg, row, middle);
}

/// A stroke for each moment; its text only where it does not run into the one before.
void GanttChart::DrawMarks(SvgWriter& svg, const GanttRow& row, double middle) const {
  double free_from = area_.low.x - 10;
  for (const GanttMark& mark : row.marks) {
    const double x = X(mark.at), half = 0.22 * row_height_;
    svg.Polyline(Polyline{{x, middle - half}, {x, middle + half}}, {.stroke = kHaloColour, .width = 1.3});
    const double width = TextWidth(mark.text, kMarkSize, true);
    if (row_height_ < 2 * kMarkSize || x - 0.5 * width < free_from) continue;
    svg.Text({.at = {x, middle - half - 1.5},
              .text = mark.text,
              .size = kMarkSize,
              .anchor = TextAnchor::kMiddle,
              .bold = true});
    free_from = x + 0.5 * width + 2;
  }
}

}  // namespace tautline
