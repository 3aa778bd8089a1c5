#include "tautline/geometry/grow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// How many equal steps an arc needs so that tangents at their ends meet within the stated error.
int ArcSteps(double angle, double arc_error) {
  const double largest_step = 2 * std::acos(1 / (1 + arc_error));
  return std::max(1, static_cast<int>(std::ceil(angle / largest_step - 1e-9)));
}

/// The unit vector to the right of a -> b.
Point RightNormal(Point a, Point b) {
  const Point d = b - a;
  return 1 / Norm(d) * Point{d.y, -d.x};
}

Point Rotate(Point v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

/// The fan at a convex corner, from the normal of the edge before it to that of the edge after it.
Ring CornerFan(Point corner, Point normal, Point next_normal, double radius, double arc_error) {
  // The corner is convex, but rounding may say otherwise when it is nearly straight or nearly a needle.
  const double angle = std::fabs(std::atan2(Cross(normal, next_normal), Dot(normal, next_normal)));
  const int steps = ArcSteps(angle, arc_error);
  const double step = angle / steps;
  Ring fan{corner, corner + radius * normal};
  for (int i = 0; i < steps; ++i) {
    fan.push_back(corner + radius / std::cos(step / 2) * Rotate(normal, (i + 0.5) * step));
  }
  fan.push_back(corner + radius * next_normal);
  return fan;
}

}  // namespace

std::vector<Ring> GrowthPieces(std::span<const Point> ring, double radius, double arc_error) {
  const Ring clean = DropStraight(ring);
  std::vector<Ring> pieces;
  const std::size_t n = clean.size();
  if (n == 1) pieces.push_back(CircumscribedPolygon(clean[0], radius, arc_error));
  if (n < 2) return pieces;
  for (std::size_t i = 0; i < n; ++i) {
    const Point a = clean[i], b = clean[(i + 1) % n], c = clean[(i + 2) % n];
    const Point normal = RightNormal(a, b);
    const Point offset = radius * normal;
    pieces.push_back({a, a + offset, b + offset, b});
    // Straight on cannot be, so no turn is a turn back.
    if (Orientation(a, b, c) >= 0) pieces.push_back(CornerFan(b, normal, RightNormal(b, c), radius, arc_error));
  }
  return pieces;
}

int CircleSides(double arc_error) { return std::max(3, ArcSteps(2 * std::numbers::pi, arc_error)); }

Ring CircumscribedPolygon(Point centre, double radius, double arc_error) {
  const int sides = CircleSides(arc_error);
  const double step = 2 * std::numbers::pi / sides;
  const double outer = radius / std::cos(step / 2);
  Ring polygon;
  for (int i = 0; i < sides; ++i) polygon.push_back(centre + Rotate({outer, 0}, (i + 0.5) * step));
  return polygon;
}

}  // namespace tautline
