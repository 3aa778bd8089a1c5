// The legend of a picture: what each line and symbol means, with its numbers.
#ifndef TAUTLINE_DRAW_LEGEND_H_
#define TAUTLINE_DRAW_LEGEND_H_

#include <string>
#include <variant>
#include <vector>

#include "tautline/draw/line_style.h"
#include "tautline/draw/marker.h"
#include "tautline/draw/svg_writer.h"

namespace tautline {

/// A patch of ground.
struct GroundSwatch {
  std::string fill;                    ///< Colour of the ground.
  std::string edge = kBoundaryColour;  ///< Colour of its boundary.
  bool hatched = false;                ///< The pattern of the clearance band instead of `fill`.
};

/// A numbered line.
struct NumberedSwatch {
  std::string number;  ///< As it stands in the disc on the line.
  LineStyle line;      ///< How the line itself is drawn.
};

/// What a legend shows in front of an entry.
using Swatch = std::variant<std::monostate, LineStyle, Marker, GroundSwatch, NumberedSwatch>;

/// One line of a legend with its sample.
struct LegendEntry {
  Swatch swatch;                          ///< monostate: a heading without a sample.
  std::string text;                       ///< What the sample stands for.
  std::vector<std::string> details = {};  ///< Smaller lines below.
};

/// A legend broken into lines and columns.
class Legend {
 public:
  /// The room that the legend has.
  struct Options {
    double width = 280;  ///< Of all columns, pixels.
    int columns = 1;     ///< How many columns share the width.
  };

  /// Breaks the entries into lines and columns. O(length of all texts).
  Legend(const std::vector<LegendEntry>& entries, const Options& options);

  /// The height of the highest column, pixels.
  double height() const { return height_; }
  /// Draws it with its upper left corner at `corner`, pixels.
  void Draw(SvgWriter& svg, Point corner) const;

 private:
  struct Block {
    Swatch swatch;
    std::vector<std::string> lines;
    std::vector<std::string> details = {};
    double height = 0;
    int column = 0;
    double top = 0;
  };

  void Flow();
  bool FillColumns(double limit);
  void DrawBlock(SvgWriter& svg, const Block& block, Point corner) const;

  Options options_;
  double column_width_ = 0;
  double height_ = 0;
  std::vector<Block> blocks_;
};

}  // namespace tautline

#endif  // TAUTLINE_DRAW_LEGEND_H_
