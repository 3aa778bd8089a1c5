#include "tautline/planners/tether/cell_slabs.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "tautline/base/double_bits.h"
#include "tautline/geometry/polygon.h"
#include "tautline/planners/tether/disc_area.h"

namespace tautline {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Range {
  double low = 0;
  double high = 0;
};

Range RangeOfX(std::span<const Point> ring) {
  Range range{kInfinity, -kInfinity};
  for (const Point p : ring) range = {std::min(range.low, p.x), std::max(range.high, p.x)};
  return range;
}

/// Where the column x passes a convex ring; nothing beside it.
std::optional<Range> ColumnIn(std::span<const Point> ring, double x) {
  Range range{kInfinity, -kInfinity};
  const auto add = [&range](double y) { range = {std::min(range.low, y), std::max(range.high, y)}; };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    if (a.x == x) add(a.y);
    if ((a.x < x && x < b.x) || (b.x < x && x < a.x)) add(a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y));
  }
  if (range.low > range.high) return std::nullopt;
  return range;
}

/// The part of a convex ring on the side of `line` where sign * SideOf >= 0.
Ring CutBy(const Ring& ring, const SightLine& line, int sign) {
  Ring cut;
  const Point along = line.tip - line.tail;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    const int at_a = sign * line.SideOf(a), at_b = sign * line.SideOf(b);
    if (at_a >= 0) cut.push_back(a);
    if (at_a * at_b >= 0) continue;
    const double from = Cross(along, a - line.tail), to = Cross(along, b - line.tail);
    cut.push_back(Lerp(a, b, std::clamp(from / (from - to), 0.0, 1.0)));
  }
  return cut;
}

/// The part of a convex ring with low <= x <= high.
Ring CutToColumns(const Ring& ring, Range range) {
  Ring cut = ring;
  for (const double sign : {1.0, -1.0}) {
    const double bound = sign > 0 ? range.low : range.high;
    if (!std::isfinite(bound)) continue;
    Ring next;
    for (std::size_t i = 0; i < cut.size(); ++i) {
      const Point a = cut[i], b = cut[(i + 1) % cut.size()];
      const double at_a = sign * (a.x - bound), at_b = sign * (b.x - bound);
      if (at_a >= 0) next.push_back(a);
      if ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0)) {
        next.push_back({bound, a.y + (bound - a.x) / (b.x - a.x) * (b.y - a.y)});
      }
    }
    cut = std::move(next);
  }
  return cut;
}

double DistanceTo(const Ring& ring, Point p) {
  double least = kInfinity;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    least = std::min(least, DistanceToSegment(p, ring[i], ring[(i + 1) % ring.size()]));
  }
  return least;
}

double FarthestFrom(const Ring& ring, Point p) {
  double most = 0;
  for (const Point q : ring) most = std::max(most, Distance(p, q));
  return most;
}

Point MeanOf(const Ring& ring) {
  Point sum;
  for (const Point p : ring) sum = sum + p;
  return (1.0 / static_cast<double>(ring.size())) * sum;
}

/// The angles where a circle has x at least `bound` (`sign` 1) or at most (-1).
AngleRange BesideColumn(const Disc& disc, double bound, int sign) {
  return sign > 0 ? LeftOfLine(disc, {bound, disc.centre.y}, {bound, disc.centre.y - 1})
                  : LeftOfLine(disc, {bound, disc.centre.y}, {bound, disc.centre.y + 1});
}

class Slicer {
 public:
  Slicer(const FreeMesh& mesh, const SightCell& cell, const SlabOptions& options)
      : mesh_(mesh), cell_(cell), disc_(options.disc), join_(options.join), sliver_(options.sliver) {
    Ring triangle;
    for (int i = 0; i < 3; ++i) triangle.push_back(mesh.triangulation().corner(cell.triangle, i));
    ring_ = CutBy(CutBy(triangle, cell.right, 1), cell.left, -1);
  }

  std::vector<CellSlab> Run(std::span<const double> columns) {
    if (ring_.size() < 3 || DistanceTo(ring_, disc_.centre) >= disc_.radius - join_) return {};
    const Range extent = RangeOfX(ring_);
    Look();
    std::vector<CellSlab> slabs;
    Range range{-kInfinity, kInfinity};
    double low_cut = kInfinity;  // None.
    for (const double column : columns) {
      if (column < extent.low - sliver_ || column > extent.high + sliver_) continue;
      if (column <= extent.low + sliver_) {
        low_cut = column;
        continue;
      }
      const bool last = column >= extent.high - sliver_;
      if (!last) range.high = column;
      AddSlab(range, {low_cut, column}, slabs);
      low_cut = column;
      range = {column, kInfinity};
      if (last) return slabs;
    }
    AddSlab(range, {low_cut, kInfinity}, slabs);
    return slabs;
  }

 private:
  /// What every slab has a share in.
  void Look() {
    if (FarthestFrom(ring_, disc_.centre) > disc_.radius) arcs_ = ArcsIn(mesh_, cell_, disc_);
    for (int i = 0; i < 3; ++i) {
      if (!mesh_.triangle(cell_.triangle).is_constrained(i)) continue;
      const auto seen = PartInCone(mesh_, cell_, i);
      if (!seen) continue;
      if (const auto part = PartInDisc(*seen, disc_)) walls_.emplace_back(i, *part);
    }
  }

  /// The slab of the columns within `range`, with cuts at the columns of `cut` that are finite.
  void AddSlab(Range range, Range cut, std::vector<CellSlab>& slabs) const {
    const Ring ring = CutToColumns(ring_, range);
    if (ring.size() < 3 || DistanceTo(ring, disc_.centre) >= disc_.radius - join_) return;
    CellSlab slab{.sample = MeanOf(ring), .area = AreaInDisc(ring, disc_), .pieces = {}};
    AddWalls(range, slab);
    AddArcs(range, slab);
    const Range extent = RangeOfX(ring);
    if (std::isfinite(cut.low)) AddCut(ring, std::max(cut.low, extent.low), cut.low, false, slab);
    if (std::isfinite(cut.high)) AddCut(ring, std::min(cut.high, extent.high), cut.high, true, slab);
    slabs.push_back(std::move(slab));
  }

  void AddWalls(Range range, CellSlab& slab) const {
    for (const auto& [side, part] : walls_) {
      const double width = part.high.x - part.low.x;  // Not negative: points are ordered by x.
      double from = part.from, to = part.to;
      if (width > 0) {
        from = std::max(from, (range.low - part.low.x) / width);
        to = std::min(to, (range.high - part.low.x) / width);
      } else if (part.low.x < range.low || part.low.x > range.high) {
        continue;
      }
      if (from >= to) continue;
      Point a = from == 0 ? part.low : Lerp(part.low, part.high, from);
      Point b = to == 1 ? part.high : Lerp(part.low, part.high, to);
      if (mesh_.triangulation().corner(cell_.triangle, Next(side)) == part.high) std::swap(a, b);
      slab.pieces.push_back({.kind = PieceKind::kWall,
                             .from = a,
                             .to = b,
                             .source = 3 * static_cast<std::int64_t>(cell_.triangle.index()) + side});
    }
  }

  void AddArcs(Range range, CellSlab& slab) const {
    std::vector<AngleSpan> arcs = arcs_;
    if (std::isfinite(range.low)) arcs = Intersect(arcs, BesideColumn(disc_, range.low, 1));
    if (std::isfinite(range.high)) arcs = Intersect(arcs, BesideColumn(disc_, range.high, -1));
    for (const AngleSpan& arc : arcs) {
      slab.pieces.push_back({.kind = PieceKind::kArc,
                             .from = PointAt(disc_, arc.low),
                             .to = PointAt(disc_, arc.high),
                             .centre = disc_.centre,
                             .radius = disc_.radius,
                             .sweep = arc.width()});
    }
  }

  /// Whether a side of the triangle runs along the column and is a wall: a ray there parts nothing.
  bool IsWall(double column) const {
    for (int i = 0; i < 3; ++i) {
      if (!mesh_.triangle(cell_.triangle).is_constrained(i)) continue;
      const Point a = mesh_.triangulation().corner(cell_.triangle, Next(i));
      const Point b = mesh_.triangulation().corner(cell_.triangle, Previous(i));
      if (std::fabs(a.x - column) <= sliver_ && std::fabs(b.x - column) <= sliver_) return true;
    }
    return false;
  }

  /// The ring's part of a column, upward where the slab lies to the left of it. Where the column runs along the end of
  /// the cell, rounding may part the two: there the part is taken just inside.
  void AddCut(const Ring& ring, double x, double column, bool upward, CellSlab& slab) const {
    const Range extent = RangeOfX(ring);
    const double inner = upward ? std::min(x, extent.high - 2 * sliver_) : std::max(x, extent.low + 2 * sliver_);
    const bool at_end = column >= RangeOfX(ring_).high - sliver_ || column <= RangeOfX(ring_).low + sliver_;
    if (at_end && IsWall(column)) return;
    const auto chord = ColumnIn(ring, at_end ? inner : x);
    const double aside = column - disc_.centre.x;
    const double square = (disc_.radius - aside) * (disc_.radius + aside);
    if (!chord || square <= 0) return;
    const double half = std::sqrt(square);
    const double low = std::max(chord->low, disc_.centre.y - half), high = std::min(chord->high, disc_.centre.y + half);
    if (low >= high) return;
    const Point bottom{column, low}, top{column, high};
    slab.pieces.push_back({.kind = PieceKind::kCut,
                           .from = upward ? bottom : top,
                           .to = upward ? top : bottom,
                           .source = static_cast<std::int64_t>(DoubleBits(column))});
  }

  const FreeMesh& mesh_;
  const SightCell& cell_;
  Disc disc_;
  double join_;
  double sliver_;
  Ring ring_;
  std::vector<AngleSpan> arcs_;
  std::vector<std::pair<int, SidePart>> walls_;
};

}  // namespace

RayCuts::RayCuts(const FreeSpace& space, const FreeMesh& mesh, double sliver) : first_{0} {
  std::vector<Point> feet;
  for (const Island& island : space.islands) feet.push_back(island.representative);
  std::sort(feet.begin(), feet.end());
  const std::size_t count = mesh.triangulation().triangles().size();
  for (std::size_t t = 0; t < count; ++t) {
    const TriangleId id(t);
    if (mesh.IsFree(id)) {
      const Ring ring{mesh.triangulation().corner(id, 0), mesh.triangulation().corner(id, 1),
                      mesh.triangulation().corner(id, 2)};
      const Range range = RangeOfX(ring);
      auto foot = std::lower_bound(feet.begin(), feet.end(), Point{range.low - sliver, -kInfinity});
      for (; foot != feet.end() && foot->x <= range.high + sliver; ++foot) {
        const auto chord = ColumnIn(ring, std::clamp(foot->x, range.low, range.high));
        // A foot lies in blocked ground: the column passes a free triangle all above it or all below.
        if (!chord || 0.5 * (chord->low + chord->high) < foot->y) continue;
        if (columns_.size() == first_.back() || columns_.back() != foot->x) columns_.push_back(foot->x);
      }
    }
    first_.push_back(columns_.size());
  }
}

std::vector<CellSlab> SlabsOf(const FreeMesh& mesh, const RayCuts& cuts, const SightCell& cell,
                              const SlabOptions& options) {
  return Slicer(mesh, cell, options).Run(cuts.In(cell.triangle));
}

}  // namespace tautline
