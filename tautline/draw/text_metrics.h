// How much room a line of text takes, estimated without a font.
#ifndef TAUTLINE_DRAW_TEXT_METRICS_H_
#define TAUTLINE_DRAW_TEXT_METRICS_H_

#include <string>
#include <string_view>
#include <vector>

namespace tautline {

/// The width in pixels of `text` (UTF-8) in a sans-serif font of `size` pixels, rather too much
/// than too little: the widths are those of DejaVu Sans, the widest of the usual fonts.
double TextWidth(std::string_view text, double size, bool bold = false);

/// `text`, or its beginning with "…" when it is wider than `width`.
std::string Ellipsize(std::string_view text, double size, double width);

/// The font and the room of a text.
struct WrapOptions {
  double size = 12;    ///< Of the font, pixels.
  double width = 200;  ///< Of a line, pixels.
  int max_lines = 3;   ///< The last line is shortened when there is more.
  bool bold = false;   ///< Heavy letters, which are wider.
};

/// `text` broken at spaces into lines.
std::vector<std::string> Wrap(std::string_view text, const WrapOptions& options);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_TEXT_METRICS_H_
