#include "tautline/planners/tether/region_ring.h"

namespace tautline {

double Length(const RegionPiece& piece) {
  return piece.is_arc() ? piece.radius * piece.sweep : Distance(piece.from, piece.to);
}

Point Middle(const RegionPiece& piece) {
  if (!piece.is_arc()) return Lerp(piece.from, piece.to, 0.5);
  const Point start = piece.from - piece.centre;
  const double angle = std::atan2(start.y, start.x) + 0.5 * piece.sweep;
  return piece.centre + piece.radius * Point{std::cos(angle), std::sin(angle)};
}

double GreenArea(const RegionPiece& piece, Point origin) {
  if (!piece.is_arc()) return 0.5 * Cross(piece.from - origin, piece.to - origin);
  return 0.5 * (piece.radius * piece.radius * piece.sweep + Cross(piece.centre - origin, piece.to - piece.from));
}

double AreaOf(std::span<const RegionRing> rings) {
  double area = 0;
  for (const RegionRing& ring : rings) area += ring.area;
  return area;
}

}  // namespace tautline
