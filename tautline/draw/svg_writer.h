// A small writer of SVG: shapes, text and groups in pixels, y down, with compact and reproducible
// bytes.
#ifndef TAUTLINE_DRAW_SVG_WRITER_H_
#define TAUTLINE_DRAW_SVG_WRITER_H_

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tautline/geometry/polygon.h"

namespace tautline {

/// `text` fit to stand in XML: the five special characters escaped, control characters and broken
/// UTF-8 replaced.
std::string EscapeXml(std::string_view text);

/// How a shape is painted. Colours are CSS colours; "none" paints nothing.
struct SvgStyle {
  std::string fill = "none";    ///< Colour inside.
  std::string stroke = "none";  ///< Colour of the edge.
  double width = 1;             ///< Of the stroke, pixels.
  std::string dashes;           ///< Lengths of dashes and gaps, pixels: "6 3".
  double opacity = 1;           ///< Of the fill, 0 to 1.
};

/// The fill that DefineHatch defines.
inline constexpr char kHatchFill[] = "url(#tautline-hatch)";

/// A line of straight pieces and circular arcs, pixels.
struct SvgCurve {
  /// From where the one before ended.
  struct Step {
    Point to;                   ///< Where it ends.
    double radius = 0;          ///< 0: straight. An arc is less than a half turn.
    bool anticlockwise = true;  ///< As seen in the picture.
  };
  Point start;              ///< Where the first step starts.
  std::vector<Step> steps;  ///< One after the other.
  bool closed = false;      ///< Whether it ends where it starts.
};

/// Which part of a text stands at its point.
enum class TextAnchor { kStart, kMiddle, kEnd };

/// How something moves, over and over: from keyframe to keyframe in straight lines.
struct SvgMotion {
  std::vector<double> times;  ///< Of the keyframes, from 0 to 1, ascending.
  double duration_s = 1;      ///< Of one round, seconds.
};

/// One line of text.
struct SvgText {
  Point at;                                ///< The start, middle or end of the base line, by `anchor`.
  std::string text;                        ///< UTF-8; it is escaped.
  double size = 12;                        ///< Pixels.
  TextAnchor anchor = TextAnchor::kStart;  ///< What `at` is.
  bool bold = false;                       ///< Heavy letters.
  bool italic = false;                     ///< Slanted letters.
  std::string fill = "#1a1a1a";            ///< Colour of the letters.
  std::string halo;                        ///< Colour of an outline around the letters; "": none.
};

/// Builds one SVG document. All coordinates are pixels with y down; points that are not finite are
/// left out.
class SvgWriter {
 public:
  /// The document as a whole.
  struct Options {
    double width = 1000;  ///< Pixels.
    double height = 600;  ///< Pixels.
    int decimals = 2;     ///< Of coordinates; 1 keeps drawings of large maps lean.
    std::string title;    ///< Read out by screen readers.
  };

  /// Starts the document.
  explicit SvgWriter(const Options& options);

  /// A group that names its layer; groups may be nested and must be closed.
  void OpenGroup(std::string_view layer);
  /// Closes the group that was opened last.
  void CloseGroup();

  /// A group that shows only what lies inside of `window`.
  void OpenWindow(std::string_view layer, const Box& window);
  /// Closes the window that was opened last.
  void CloseWindow();

  /// Defines a pattern of diagonal lines; SvgStyle::fill = kHatchFill uses it.
  void DefineHatch(std::string_view ground, std::string_view line);

  /// The closed rings as one shape filled by the even-odd rule, so that rings inside of rings are
  /// holes. Rings too small to see become dots.
  void Polygon(std::span<const Ring> rings, const SvgStyle& style);

  /// Open lines as one shape.
  void Polylines(std::span<const Polyline> lines, const SvgStyle& style);

  /// One open line.
  void Polyline(std::span<const Point> line, const SvgStyle& style);

  /// The curves as one shape, filled by the even-odd rule; arcs stay arcs.
  void Curves(std::span<const SvgCurve> curves, const SvgStyle& style);

  /// A smooth curve from the first to the last point that is pulled towards the points between (a
  /// quadratic B-spline).
  void Smooth(std::span<const Point> points, const SvgStyle& style);

  /// A circle; `radius` in pixels.
  void Circle(Point centre, double radius, const SvgStyle& style);

  /// A box, its corners rounded by `corner_radius` pixels.
  void Rectangle(const Box& box, const SvgStyle& style, double corner_radius = 0);

  /// A filled arrow head with its middle at `middle` and its tip towards `direction`.
  void ArrowHead(Point middle, Point direction, double size, const SvgStyle& style);

  /// One line of text.
  void Text(const SvgText& text);

  /// An open line that moves; one line per keyframe, all with the same number of points. Viewers without animation show
  /// the last keyframe, as for all that moves.
  void MovingPolyline(std::span<const tautline::Polyline> keyframes, const SvgMotion& motion, const SvgStyle& style);

  /// A circle that moves; its centre in each keyframe.
  void MovingCircle(std::span<const Point> centres, double radius, const SvgMotion& motion, const SvgStyle& style);

  /// Texts that take turns: one per keyframe, each from then to the next.
  void TextInTurns(const SvgText& text, std::span<const std::string> turns, const SvgMotion& motion);

  /// The whole document; the writer is used up.
  std::string Finish();

 private:
  void Path(const std::string& data, const SvgStyle& style, bool even_odd);
  void AppendStyle(const SvgStyle& style, bool open_element = false);
  void Animate(std::string_view attribute, const SvgMotion& motion, std::string_view mode,
               std::span<const std::string> values);
  void OpenText(const SvgText& text, std::string_view more = "");
  std::string Number(double value) const;
  std::string Pair(Point p) const;

  std::string out_;
  int decimals_;
  int open_ = 0;
};

}  // namespace tautline

#endif  // TAUTLINE_DRAW_SVG_WRITER_H_
