// Regions of the plane bounded by straight pieces and circular arcs.
#ifndef TAUTLINE_PLANNERS_TETHER_REGION_RING_H_
#define TAUTLINE_PLANNERS_TETHER_REGION_RING_H_

#include <cstdint>
#include <span>
#include <vector>

#include "tautline/geometry/point.h"

namespace tautline {

/// What a piece of a region's boundary is.
enum class PieceKind : std::uint8_t {
  kWall,  ///< Along the boundary of the free space.
  kArc,   ///< Where the tether ends: a circle about the last bend.
  kCut,   ///< Along an obstacle's ray, where the word changes; only in the regions of sheets.
};

/// One directed piece of a region's boundary, the region on its left. Straight, or an arc counter-clockwise about its
/// centre.
struct RegionPiece {
  PieceKind kind = PieceKind::kWall;  ///< What bounds the region here.
  Point from;                         ///< Where it starts.
  Point to;                           ///< Where it ends.
  Point centre;                       ///< Of an arc.
  double radius = 0;                  ///< Of an arc, metres; 0 for a straight piece.
  double sweep = 0;                   ///< Of an arc, radians, 0 to 2 pi.
  std::int64_t source = 0;  ///< Of a straight piece: a number that all pieces of one wall, or of one cut, share.

  /// Whether it is an arc; straight otherwise.
  bool is_arc() const { return kind == PieceKind::kArc; }
};

/// The metres along a piece.
double Length(const RegionPiece& piece);

/// The point half way along a piece.
Point Middle(const RegionPiece& piece);

/// A closed sequence of pieces, each of which starts where the one before ends.
struct RegionRing {
  std::vector<RegionPiece> pieces;  ///< In order.
  double area = 0;  ///< Square metres, by Green's formula: positive around a region, negative around a hole.
};

/// The share of one piece in the area on its left: half the integral of x dy - y dx along it, about `origin`. Exact
/// but for rounding.
double GreenArea(const RegionPiece& piece, Point origin);

/// The sum of the rings' areas.
double AreaOf(std::span<const RegionRing> rings);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_REGION_RING_H_
