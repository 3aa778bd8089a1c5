// What all pictures of a scene share: the map with its names, lines, symbols and labels, title and
// legend.
#ifndef TAUTLINE_DRAW_FIGURE_H_
#define TAUTLINE_DRAW_FIGURE_H_

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tautline/draw/label_placer.h"
#include "tautline/draw/marker.h"
#include "tautline/draw/page.h"
#include "tautline/draw/plot.h"
#include "tautline/scene/free_space.h"

namespace tautline {

/// What a figure says around its map.
struct FigureContent {
  std::string title;                     ///< The answer in words.
  std::vector<std::string> notes = {};   ///< Sentences below it.
  std::vector<LegendEntry> legend = {};  ///< In front of the entries of the ground.
  std::vector<std::string> tints = {};   ///< Colours of the components; missing ones are white.
  std::vector<Point> shown = {};         ///< Points besides those of the world that the map should hold, metres.
  bool outline_obstacles = false;        ///< Draws the edges of obstacles that are merged.
  std::vector<PlotContent> plots = {};   ///< One below the other, below map and legend.
};

/// A picture in the making. Lines are drawn in the order of the calls, over the ground; symbols,
/// labels and names come on top, each where it disturbs least.
class Figure {
 public:
  /// Lays out the page and draws the ground. Scene and space must outlive the figure.
  Figure(const Scene& scene, const FreeSpace& space, const FigureContent& content);

  /// A line in metres; its layer is the class of its group in the SVG.
  void Line(std::string_view layer, std::span<const Point> line, const LineStyle& style);

  /// A line in pixels.
  void PixelLine(std::string_view layer, std::span<const Point> line, const LineStyle& style);

  /// Curves in pixels as one shape of its own layer, under all labels. Labels need not keep off.
  void Shape(std::string_view layer, std::span<const SvgCurve> curves, const SvgStyle& style);

  /// Short dotted rays upward from islands to the rim of the map.
  void Rays(const std::set<ObstacleId>& islands);

  /// A symbol at a point in metres, with its name beside it when not empty. Points outside of the
  /// map are drawn on its rim.
  void Mark(Marker marker, Point at, const std::string& label = "");

  /// A label, of one or more lines, beside a line in metres.
  void LabelLine(std::span<const Point> line, const std::string& label, const std::string& colour);

  /// A label about a point in metres, on it where that disturbs nothing and `room` (metres) is
  /// enough.
  void LabelPoint(Point at, const std::string& label, double room);

  /// A number on a line in pixels.
  void Number(std::span<const Point> line, const std::string& number, const std::string& colour);

  /// Islands whose names must not be left out.
  void Name(const std::set<ObstacleId>& islands);

  /// From metres to pixels of this figure.
  const View& view() const { return view_; }

  /// The SVG document; the figure is used up.
  std::string Finish();

 private:
  struct PendingMark {
    Marker marker;
    Point at;
    std::string label;
  };
  struct PendingLabel {
    Polyline line;
    std::string text;
    std::string colour;
    bool beside = true;  ///< Not on the line or point itself.
  };

  void DiscourageGround();
  Point OnMap(Point at) const;
  void DrawNumbers();
  void DrawPlots();
  void DrawMarks();
  void PlaceMarkLabels(std::vector<SvgText>& texts);
  void PlaceLineLabels(std::vector<SvgText>& texts);

  const Scene& scene_;
  const FreeSpace& space_;
  Page page_;
  View view_;
  SvgWriter svg_;
  LabelPlacer placer_;
  std::set<ObstacleId> named_;
  std::vector<PendingMark> marks_;
  std::vector<PendingLabel> line_labels_;
  std::vector<PendingLabel> numbers_;
  std::vector<PlotContent> plots_;
};

/// How many decimals lengths have in pictures of this space.
int LengthDecimals(const FreeSpace& space);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_FIGURE_H_
