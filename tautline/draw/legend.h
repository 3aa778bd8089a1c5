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
  std::string fill;
  std::string edge = kBoundaryColour;
  bool hatched = false;  ///< The pattern of the clearance band instead of `fill`.
};

/// A numbered line.
struct NumberedSwatch {
  std::string number;
  LineStyle line;
};

using Swatch = std::variant<std::monostate, LineStyle, Marker, GroundSwatch, NumberedSwatch>;

struct LegendEntry {
  Swatch swatch;  ///< monostate: a heading without a sample.
  std::string text;
  std::vector<std::string> details = {};  ///< Smaller lines below.
};

/// A legend broken into lines and columns.
class Legend {
 public:
  struct Options {
    double width = 280;  ///< Of all columns, pixels.
    int columns = 1;
  };
  Legend(const std::vector<LegendEntry>& entries, const Options& options);

  double height() const { return height_; }
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
