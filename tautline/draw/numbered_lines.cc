#include "tautline/draw/numbered_lines.h"

#include <algorithm>

#include "tautline/draw/curve.h"

namespace tautline {
namespace {

constexpr double kSpacing = 3.6;  // Pixels between lines on a shared edge.

LineStyle StyleOf(std::size_t rank, std::size_t lines) {
  return ClassLine(static_cast<int>(rank), static_cast<int>(std::min(lines, kMostNumberedLines)));
}

}  // namespace

void DrawNumberedLines(Figure& figure, std::span<const NumberedLine> lines) {
  const std::size_t numbered = std::min(lines.size(), kMostNumberedLines);
  const std::size_t drawn = std::min(lines.size(), kMostNumberedLines + kMostThinLines);
  for (std::size_t i = drawn; i > numbered; --i) figure.Line("other-class", lines[i - 1].points, kOtherClassLine);
  std::vector<Polyline> pixels;
  for (std::size_t i = 0; i < numbered; ++i) pixels.push_back(figure.view().ToPixels(lines[i].points));
  const std::vector<Polyline> moved = RunSideBySide(pixels, kSpacing);
  for (std::size_t i = numbered; i > 0; --i) figure.PixelLine("class", moved[i - 1], StyleOf(i - 1, lines.size()));
  for (std::size_t i = 0; i < numbered; ++i) {
    figure.Number(moved[i], std::to_string(lines[i].number), StyleOf(i, lines.size()).colour);
  }
}

void AppendNumberedEntries(std::span<const NumberedLine> lines, std::vector<LegendEntry>& legend) {
  const std::size_t numbered = std::min(lines.size(), kMostNumberedLines);
  for (std::size_t i = 0; i < numbered; ++i) {
    legend.push_back(
        {NumberedSwatch{std::to_string(lines[i].number), StyleOf(i, lines.size())}, lines[i].text, lines[i].details});
  }
  const std::size_t more = lines.size() - numbered;
  if (more == 0) return;
  const std::string thin = more > kMostThinLines ? "; " + std::to_string(kMostThinLines) + " of them drawn" : "";
  legend.push_back({kOtherClassLine, std::to_string(more) + " more, longer" + thin});
}

}  // namespace tautline
