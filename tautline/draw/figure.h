// What all pictures of a scene share: the map with its names, lines, symbols and labels, title and
// legend.
#ifndef TAUTLINE_DRAW_FIGURE_H_
#define TAUTLINE_DRAW_FIGURE_H_

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tautline/draw/map_drawing.h"
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
  void Line(std::string_view layer, std::span<const Point> line, const LineStyle& style) {
    map_.Line(layer, line, style);
  }

  /// A line in pixels.
  void PixelLine(std::string_view layer, std::span<const Point> line, const LineStyle& style) {
    map_.PixelLine(layer, line, style);
  }

  /// Curves in pixels as one shape of its own layer, under all labels. Labels need not keep off.
  void Shape(std::string_view layer, std::span<const SvgCurve> curves, const SvgStyle& style) {
    map_.Shape(layer, curves, style);
  }

  /// Short dotted rays upward from islands to the rim of the map.
  void Rays(const std::set<ObstacleId>& islands) { map_.Rays(islands); }

  /// A symbol at a point in metres, with its name beside it when not empty. Points outside of the
  /// map are drawn on its rim.
  void Mark(Marker marker, Point at, const std::string& label = "") { map_.Mark(marker, at, label); }

  /// A label, of one or more lines, beside a line in metres.
  void LabelLine(std::span<const Point> line, const std::string& label, const std::string& colour) {
    map_.LabelLine(line, label, colour);
  }

  /// A label about a point in metres, on it where that disturbs nothing and `room` (metres) is
  /// enough.
  void LabelPoint(Point at, const std::string& label, double room) { map_.LabelPoint(at, label, room); }

  /// A number on a line in pixels.
  void Number(std::span<const Point> line, const std::string& number, const std::string& colour) {
    map_.Number(line, number, colour);
  }

  /// Islands whose names must not be left out.
  void Name(const std::set<ObstacleId>& islands) { map_.Name(islands); }

  /// The map, for what draws on maps of all kinds.
  MapDrawing& map() { return map_; }

  /// From metres to pixels of this figure.
  const View& view() const { return map_.view(); }

  /// The SVG document; the figure is used up.
  std::string Finish();

 private:
  void DrawPlots();

  const Scene& scene_;
  const FreeSpace& space_;
  Page page_;
  SvgWriter svg_;
  MapDrawing map_;
  std::vector<PlotContent> plots_;
};

/// What stands beside the scale bar: the scene's file and the extent of its world.
std::string SceneRemark(const Scene& scene, const FreeSpace& space);

/// How many decimals lengths have in pictures of this space.
int LengthDecimals(const FreeSpace& space);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_FIGURE_H_
