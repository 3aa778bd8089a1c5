// Where the parts of a picture go: title above, map, legend beside or below it, scale bar under the
// map.
#ifndef TAUTLINE_DRAW_PAGE_H_
#define TAUTLINE_DRAW_PAGE_H_

#include <string>
#include <vector>

#include "tautline/draw/legend.h"
#include "tautline/draw/view.h"

namespace tautline {

/// What stands on a page.
struct PageContent {
  Box world;                        ///< What the map shows, metres.
  std::string title;                ///< The answer in words.
  std::vector<std::string> notes;   ///< Sentences below the title.
  std::vector<LegendEntry> legend;  ///< From top to bottom.
  double below = 0;                 ///< Height of a strip below everything else, pixels.
};

/// The layout of a page about 1000 pixels wide: the legend stands to the right of tall and square
/// worlds and below wide ones.
class Page {
 public:
  /// Lays the page out. O(length of all texts).
  explicit Page(const PageContent& content);

  double width() const { return width_; }    ///< Of the page, pixels.
  double height() const { return height_; }  ///< Of the page, pixels.
  const Box& map() const { return map_; }    ///< The frame of the map, pixels.
  Box strip() const;                         ///< The strip below, within the margins, pixels.
  View view() const;                         ///< Leaves a margin inside of the frame.

  /// Draws everything but the map: title, notes, legend, scale bar and `remark` beside it.
  void DrawAround(SvgWriter& svg, const std::string& remark) const;

 private:
  void PlaceMap(Point size);
  void DrawScaleBar(SvgWriter& svg, const std::string& remark) const;

  Box world_;
  double width_ = 0;
  double height_ = 0;
  double title_height_ = 0;
  double strip_height_ = 0;
  Box map_;
  Point legend_corner_;
  std::vector<std::string> title_lines_;
  std::vector<std::string> note_lines_;
  Legend legend_;
};

}  // namespace tautline

#endif  // TAUTLINE_DRAW_PAGE_H_
