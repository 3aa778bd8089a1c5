// From the world (metres, y up) to the picture (pixels, y down).
#ifndef TAUTLINE_DRAW_VIEW_H_
#define TAUTLINE_DRAW_VIEW_H_

#include <span>

#include "tautline/geometry/polygon.h"

namespace tautline {

/// A similarity: one scale for both axes, the world's box centred in the frame of pixels and as
/// large as fits.
class View {
 public:
  /// An empty, flat or tiny box is widened about its centre until it can be shown.
  View(const Box& world, const Box& frame);

  /// From metres to pixels, whose y points down.
  Point ToPixels(Point world) const;

  /// The same for each point of a line.
  Polyline ToPixels(std::span<const Point> world) const;

  /// The scale; positive.
  double pixels_per_metre() const { return scale_; }

 private:
  Point world_centre_;
  Point frame_centre_;
  double scale_ = 1;
};

/// `box`, or a box of positive width and height about it when it is empty or flat.
Box WithoutFlatSides(const Box& box);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_VIEW_H_
