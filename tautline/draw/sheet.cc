#include "tautline/draw/sheet.h"

#include <algorithm>

#include "tautline/draw/ground.h"
#include "tautline/draw/line_style.h"
#include "tautline/draw/text_metrics.h"

namespace tautline {
namespace {

constexpr double kPageWidth = 1000;
constexpr double kMargin = 20;
constexpr double kGap = 16;
constexpr double kTitleSize = 17;
constexpr double kTitleLine = 22;
constexpr double kNoteSize = 13;
constexpr double kNoteLine = 17.5;
constexpr double kPanelTitleSize = 12.5;
constexpr double kPanelNoteSize = 11;
constexpr double kPanelLine = 15;
constexpr double kWidth = kPageWidth - 2 * kMargin;

/// The words above the panels, broken into lines.
struct Head {
  std::vector<std::string> title, notes;

  double height() const {
    return kTitleLine * static_cast<double>(title.size()) + kNoteLine * static_cast<double>(notes.size()) + 10;
  }
};

Head MakeHead(const SheetContent& content) {
  Head head{Wrap(content.title, {.size = kTitleSize, .width = kWidth, .max_lines = 3, .bold = true}), {}};
  for (const std::string& note : content.notes) {
    for (std::string& line : Wrap(note, {.size = kNoteSize, .width = kWidth, .max_lines = 3})) {
      head.notes.push_back(std::move(line));
    }
  }
  return head;
}

void DrawHead(SvgWriter& svg, const Head& head) {
  svg.OpenGroup("title");
  double y = kMargin;
  for (const std::string& line : head.title) {
    svg.Text({.at = {kMargin, y + 15}, .text = line, .size = kTitleSize, .bold = true});
    y += kTitleLine;
  }
  for (const std::string& line : head.notes) {
    svg.Text({.at = {kMargin, y + 12}, .text = line, .size = kNoteSize, .fill = "#333333"});
    y += kNoteLine;
  }
  svg.CloseGroup();
}

/// The height of the texts above the frames of a row.
double TextHeight(const SheetRow& row) {
  std::size_t lines = 0;
  for (const SheetPanel& panel : row.panels) lines = std::max(lines, panel.notes.size());
  return kPanelLine * static_cast<double>(lines + 1) + 5;
}

/// The texts above a frame; `at` is the upper left corner of the panel.
void DrawTexts(SvgWriter& svg, const SheetPanel& panel, Point at, double width) {
  svg.Text({.at = at + Point{0, 12},
            .text = Ellipsize(panel.title, kPanelTitleSize, width),
            .size = kPanelTitleSize,
            .bold = true});
  for (std::size_t i = 0; i < panel.notes.size(); ++i) {
    svg.Text({.at = at + Point{0, 12 + kPanelLine * static_cast<double>(i + 1)},
              .text = Ellipsize(panel.notes[i], kPanelNoteSize, width),
              .size = kPanelNoteSize,
              .fill = kSecondaryInkColour});
  }
}

void DrawRow(SvgWriter& svg, const SheetRow& row, double top) {
  double shares = 0;
  for (const SheetPanel& panel : row.panels) shares += panel.share;
  const std::size_t count = row.shares > shares ? static_cast<std::size_t>(row.shares) : row.panels.size();
  shares = std::max(shares, row.shares);
  Point at{kMargin, top};
  const double text_height = TextHeight(row);
  for (const SheetPanel& panel : row.panels) {
    const double width = SheetFrameWidth(panel.share, shares, count);
    svg.OpenGroup("panel");
    DrawTexts(svg, panel, at, width);
    panel.draw(svg, {at + Point{0, text_height}, at + Point{width, text_height + row.height}});
    svg.CloseGroup();
    at.x += width + kGap;
  }
}

}  // namespace

double SheetFrameWidth(double share, double shares, std::size_t panels) {
  return (kWidth - (static_cast<double>(panels) - 1) * kGap) * share / shares;
}

std::string DrawSheet(const SheetContent& content) {
  const Head head = MakeHead(content);
  const Legend legend(content.legend, {.width = kWidth, .columns = 3});
  double height = kMargin + head.height();
  for (const SheetRow& row : content.rows) height += TextHeight(row) + row.height + kGap;
  height += content.legend.empty() ? kMargin - kGap : legend.height() + kMargin;
  SvgWriter svg = StartPicture({.width = kPageWidth, .height = height, .decimals = 1, .title = content.title});
  DrawHead(svg, head);
  double top = kMargin + head.height();
  for (const SheetRow& row : content.rows) {
    DrawRow(svg, row, top);
    top += TextHeight(row) + row.height + kGap;
  }
  if (!content.legend.empty()) legend.Draw(svg, {kMargin, top});
  return svg.Finish();
}

}  // namespace tautline
