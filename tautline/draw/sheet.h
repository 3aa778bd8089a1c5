// Pages of several panels: title above, panels in rows, the legend below.
#ifndef TAUTLINE_DRAW_SHEET_H_
#define TAUTLINE_DRAW_SHEET_H_

#include <functional>
#include <string>
#include <vector>

#include "tautline/draw/legend.h"
#include "tautline/draw/svg_writer.h"

namespace tautline {

/// One panel.
struct SheetPanel {
  std::string title;                                 ///< In bold above it, cut to its width.
  std::vector<std::string> notes;                    ///< Lines below the title, cut likewise.
  std::function<void(SvgWriter&, const Box&)> draw;  ///< Draws into a frame of pixels.
  double share = 1;                                  ///< Of the width, compared with the others of its row.
};

/// Panels beside each other.
struct SheetRow {
  std::vector<SheetPanel> panels;  ///< From left to right.
  double height = 0;               ///< Of their frames, pixels.
  double shares = 0;               ///< Room for panels with so many shares; more where the panels have more.
};

/// What stands on the page.
struct SheetContent {
  std::string title;                     ///< The answer in words.
  std::vector<std::string> notes = {};   ///< Sentences below it.
  std::vector<SheetRow> rows;            ///< From top to bottom.
  std::vector<LegendEntry> legend = {};  ///< Below them, in three columns.
};

/// The width in pixels of a frame that has `share` of `shares` in a row of `panels` panels.
double SheetFrameWidth(double share, double shares, std::size_t panels);

/// The page as SVG, about 1000 pixels wide. Deterministic.
std::string DrawSheet(const SheetContent& content);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_SHEET_H_
