#include "tautline/draw/legend.h"

#include <algorithm>

#include "tautline/draw/curve.h"
#include "tautline/draw/text_metrics.h"

namespace tautline {
namespace {

constexpr double kSwatchWidth = 44;
constexpr double kTextIndent = kSwatchWidth + 10;
constexpr double kColumnGap = 20;
constexpr double kTextSize = 12.5;
constexpr double kLineHeight = 16;
constexpr double kDetailSize = 11;
constexpr double kDetailHeight = 14.5;
constexpr double kBlockGap = 8;
constexpr int kMostLines = 5;

/// Draws one sample of 44 x 16 pixels with its left upper corner at `corner`.
struct SampleDrawer {
  SvgWriter& svg;
  Point corner;

  Point centre() const { return corner + Point{0.5 * kSwatchWidth, 0.5 * kLineHeight}; }

  void operator()(std::monostate) const {}
  void operator()(const LineStyle& line) const {
    const Polyline sample = {corner + Point{1, 0.5 * kLineHeight}, corner + Point{kSwatchWidth - 1, 0.5 * kLineHeight}};
    DrawCurve(svg, sample, line);
  }
  void operator()(Marker marker) const {
    DrawMarker(svg, marker, centre() + (marker == Marker::kGoal ? Point{-5, 9} : Point{0, 0}));
  }
  void operator()(const GroundSwatch& ground) const {
    svg.Rectangle({corner + Point{6, 1}, corner + Point{kSwatchWidth - 6, kLineHeight - 1}},
                  {.fill = ground.hatched ? kHatchFill : ground.fill, .stroke = ground.edge, .width = 0.9});
  }
  void operator()(const NumberedSwatch& numbered) const {
    (*this)(numbered.line);
    DrawBadge(svg, numbered.number, centre(), numbered.line.colour);
  }
};

}  // namespace

Legend::Legend(const std::vector<LegendEntry>& entries, const Options& options) : options_(options) {
  column_width_ = (options.width - (options.columns - 1) * kColumnGap) / options.columns;
  for (const LegendEntry& entry : entries) {
    const bool heading = std::holds_alternative<std::monostate>(entry.swatch);
    const double width = column_width_ - (heading ? 0 : kTextIndent);
    Block block{
        .swatch = entry.swatch,
        .lines = Wrap(entry.text, {.size = kTextSize, .width = width, .max_lines = kMostLines, .bold = heading})};
    for (const std::string& detail : entry.details) {
      for (std::string& line : Wrap(detail, {.size = kDetailSize, .width = width, .max_lines = kMostLines})) {
        block.details.push_back(std::move(line));
      }
    }
    block.height = kLineHeight * static_cast<double>(block.lines.size()) +
                   kDetailHeight * static_cast<double>(block.details.size()) + kBlockGap;
    blocks_.push_back(std::move(block));
  }
  Flow();
}

void Legend::Flow() {
  double total = 0, tallest = 0;
  for (const Block& block : blocks_) {
    total += block.height;
    tallest = std::max(tallest, block.height);
  }
  double limit = std::max(tallest, total / options_.columns);
  while (!FillColumns(limit)) limit += 0.5 * kLineHeight;
}

bool Legend::FillColumns(double limit) {
  int column = 0;
  double top = 0;
  height_ = 0;
  for (Block& block : blocks_) {
    if (top > 0 && top + block.height > limit + 1e-6) {
      ++column;
      top = 0;
    }
    block.column = column;
    block.top = top;
    top += block.height;
    height_ = std::max(height_, top);
  }
  return column < options_.columns;
}

void Legend::Draw(SvgWriter& svg, Point corner) const {
  svg.OpenGroup("legend");
  for (const Block& block : blocks_) {
    DrawBlock(svg, block, corner + Point{block.column * (column_width_ + kColumnGap), block.top});
  }
  svg.CloseGroup();
}

void Legend::DrawBlock(SvgWriter& svg, const Block& block, Point corner) const {
  const bool heading = std::holds_alternative<std::monostate>(block.swatch);
  std::visit(SampleDrawer{svg, corner}, block.swatch);
  Point line = corner + Point{heading ? 0 : kTextIndent, 12.5};
  for (const std::string& text : block.lines) {
    svg.Text({.at = line, .text = text, .size = kTextSize, .bold = heading});
    line.y += kLineHeight;
  }
  line.y -= 1;
  for (const std::string& text : block.details) {
    svg.Text({.at = line, .text = text, .size = kDetailSize, .fill = kSecondaryInkColour});
    line.y += kDetailHeight;
  }
}

}  // namespace tautline
