#include "tautline/draw/view.h"

#include <algorithm>

namespace tautline {

Box WithoutFlatSides(const Box& box) {
  if (box.empty() || !IsFinite(box.low) || !IsFinite(box.high)) return {{-0.5, -0.5}, {0.5, 0.5}};
  const Point size = box.size();
  const double largest = std::max(size.x, size.y);
  // A world that is one point, or a line, is shown with some ground around it.
  const double least = largest > 0 ? 1e-3 * largest : 1;
  const Point half{0.5 * std::max(size.x, least), 0.5 * std::max(size.y, least)};
  return {box.centre() - half, box.centre() + half};
}

View::View(const Box& world, const Box& frame) {
  const Box shown = WithoutFlatSides(world);
  world_centre_ = shown.centre();
  frame_centre_ = frame.centre();
  scale_ = std::min(frame.size().x / shown.size().x, frame.size().y / shown.size().y);
}

Point View::ToPixels(Point world) const {
  const Point offset = scale_ * (world - world_centre_);
  return {frame_centre_.x + offset.x, frame_centre_.y - offset.y};
}

Polyline View::ToPixels(std::span<const Point> world) const {
  Polyline pixels;
  pixels.reserve(world.size());
  for (const Point p : world) pixels.push_back(ToPixels(p));
  return pixels;
}

}  // namespace tautline
