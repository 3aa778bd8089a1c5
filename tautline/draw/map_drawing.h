// The map of a picture in the making: ground, lines, symbols and labels, each where it disturbs least.
#ifndef TAUTLINE_DRAW_MAP_DRAWING_H_
#define TAUTLINE_DRAW_MAP_DRAWING_H_

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tautline/draw/ground.h"
#include "tautline/draw/label_placer.h"
#include "tautline/draw/line_style.h"
#include "tautline/draw/marker.h"
#include "tautline/draw/svg_writer.h"
#include "tautline/draw/view.h"
#include "tautline/scene/free_space.h"

namespace tautline {

/// What a map shows, and where.
struct MapGround {
  const World& world;      ///< Without an outline: the open plane.
  const FreeSpace& space;  ///< Of that world; must outlive the drawing. Default-constructed for the open plane.
  View view;               ///< From metres to pixels.
  GroundOptions options;   ///< With the frame of the map.
};

/// A map in the making. Lines are drawn in the order of the calls, over the ground; symbols, labels and names come on
/// top, each where it disturbs least.
class MapDrawing {
 public:
  /// Draws the ground. The writer must outlive the drawing.
  MapDrawing(SvgWriter& svg, const MapGround& map);
  MapDrawing(const MapDrawing&) = delete;
  MapDrawing& operator=(const MapDrawing&) = delete;

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
  void Mark(Marker marker, Point at, const std::string& label = "", const std::string& colour = "");

  /// A label, of one or more lines, beside a line in metres.
  void LabelLine(std::span<const Point> line, const std::string& label, const std::string& colour);

  /// A label about a point in metres, on it where that disturbs nothing and `room` (metres) is
  /// enough.
  void LabelPoint(Point at, const std::string& label, double room);

  /// A number on a line in pixels.
  void Number(std::span<const Point> line, const std::string& number, const std::string& colour);

  /// Islands whose names must not be left out.
  void Name(const std::set<ObstacleId>& islands);

  /// From metres to pixels of this map.
  const View& view() const { return view_; }

  /// The frame of the map, pixels.
  const Box& frame() const { return frame_; }

  /// What draws, for shapes that Line and Mark have not; they go below all labels.
  SvgWriter& svg() { return svg_; }

  /// Keeps labels off a box of pixels.
  void KeepFree(const Box& box) { placer_.Take(box); }

  /// Draws symbols, labels and names; the drawing is used up.
  void Finish();

 private:
  struct PendingMark {
    Marker marker;
    Point at;
    std::string label;
    std::string colour;
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
  void DrawMarks();
  void PlaceMarkLabels(std::vector<SvgText>& texts);
  void PlaceLineLabels(std::vector<SvgText>& texts);

  const FreeSpace& space_;
  Box frame_;
  View view_;
  SvgWriter& svg_;
  LabelPlacer placer_;
  std::set<ObstacleId> named_;
  std::vector<PendingMark> marks_;
  std::vector<PendingLabel> line_labels_;
  std::vector<PendingLabel> numbers_;
};

}  // namespace tautline

#endif  // TAUTLINE_DRAW_MAP_DRAWING_H_
