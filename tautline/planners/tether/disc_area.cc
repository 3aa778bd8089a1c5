#include "tautline/planners/tether/disc_area.h"

#include <algorithm>

namespace tautline {
namespace {

/// Twice the area of the disc's sector between the directions of two points, about the centre.
double SectorTwice(Point a, Point b, double radius) { return radius * radius * std::atan2(Cross(a, b), Dot(a, b)); }

/// Twice the area within the disc about 0 of the triangle of 0 and an edge.
double EdgeTwice(Point a, Point b, double radius) {
  const Point along = b - a;
  const double square = Dot(along, along);
  if (square == 0) return 0;
  const double middle = -Dot(a, along) / square;
  const Point foot = a + middle * along;
  const double rest = radius * radius - Dot(foot, foot);
  const double half = rest > 0 ? std::sqrt(rest / square) : 0;
  const double enter = std::max(0.0, middle - half), leave = std::min(1.0, middle + half);
  if (rest <= 0 || enter >= leave) return SectorTwice(a, b, radius);
  const Point p = Lerp(a, b, enter), q = Lerp(a, b, leave);
  return (enter > 0 ? SectorTwice(a, p, radius) : 0) + Cross(p, q) + (leave < 1 ? SectorTwice(q, b, radius) : 0);
}

}  // namespace

double AreaInDisc(std::span<const Point> ring, const Disc& disc) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    twice += EdgeTwice(ring[i] - disc.centre, ring[(i + 1) % ring.size()] - disc.centre, disc.radius);
  }
  return 0.5 * twice;
}

}  // namespace tautline
