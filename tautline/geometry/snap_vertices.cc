#include "tautline/geometry/snap_vertices.h"

#include <algorithm>
#include <optional>

#include "tautline/geometry/box_index.h"

namespace tautline {
namespace {

/// An edge by ring and position of its first vertex.
struct EdgePlace {
  std::size_t ring;
  std::size_t vertex;
};

/// The rings as they were, with an index over their edges.
class Boundaries {
 public:
  explicit Boundaries(const std::vector<SourcedRing>& rings) : rings_(rings), index_(Segments()) {}

  /// Where vertex p of `source` belongs: on a boundary of lower number within tolerance.
  std::optional<VertexMove> MoveOf(std::int32_t source, Point p, double tolerance) const {
    std::optional<VertexMove> best;
    double best_distance = tolerance;
    bool best_is_vertex = false;
    index_.ForEachNear(Around(p, tolerance), [&](std::size_t k) {
      const auto [ring, vertex] = places_[k];
      if (rings_[ring].source >= source) return;
      const auto [a, b] = EdgeAt(places_[k]);
      const Point end = Distance(p, a) <= Distance(p, b) ? a : b;
      const bool is_vertex = Distance(p, end) <= tolerance;
      const Point target = is_vertex ? end : NearestOnSegment(p, a, b);
      const double distance = Distance(p, target);
      if (distance > tolerance || (best_is_vertex && !is_vertex)) return;
      if (best && is_vertex == best_is_vertex && distance >= best_distance) return;
      best = VertexMove{source, rings_[ring].source, p, target};
      best_distance = distance;
      best_is_vertex = is_vertex;
    });
    return best;
  }

  /// The vertices of lower number that the open edge ab of `source` must be bent through, in its direction.
  std::vector<VertexMove> BendsOf(std::int32_t source, Point a, Point b, double tolerance) const {
    std::vector<VertexMove> bends;
    index_.ForEachAlong(a, b, tolerance, [&](std::size_t k) {
      const auto [ring, vertex] = places_[k];
      const Point v = rings_[ring].points[vertex];
      if (rings_[ring].source >= source || Distance(v, a) <= tolerance || Distance(v, b) <= tolerance) return;
      const Point foot = NearestOnSegment(v, a, b);
      if (foot == v || Distance(v, foot) > tolerance) return;
      bends.push_back({source, rings_[ring].source, foot, v});
    });
    std::sort(bends.begin(), bends.end(), [a](const VertexMove& m, const VertexMove& n) {
      return std::pair(Distance(a, m.to), m.to) < std::pair(Distance(a, n.to), n.to);
    });
    const auto same = [](const VertexMove& m, const VertexMove& n) { return m.to == n.to; };
    bends.erase(std::unique(bends.begin(), bends.end(), same), bends.end());
    return bends;
  }

 private:
  static Box Around(Point p, double margin) { return {p - Point{margin, margin}, p + Point{margin, margin}}; }

  std::pair<Point, Point> EdgeAt(EdgePlace place) const {
    const Ring& points = rings_[place.ring].points;
    return {points[place.vertex], points[(place.vertex + 1) % points.size()]};
  }

  std::vector<BoxIndex::Segment> Segments() {
    std::vector<BoxIndex::Segment> segments;
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      for (std::size_t v = 0; v < rings_[r].points.size(); ++v) {
        places_.push_back({r, v});
        segments.push_back(EdgeAt(places_.back()));
      }
    }
    return segments;
  }

  const std::vector<SourcedRing>& rings_;
  std::vector<EdgePlace> places_;
  BoxIndex index_;
};

}  // namespace

std::vector<VertexMove> SnapVertices(std::vector<SourcedRing>& rings, double tolerance) {
  const std::vector<SourcedRing> before = rings;
  const Boundaries boundaries(before);
  std::vector<VertexMove> moves;
  for (SourcedRing& ring : rings) {
    Ring snapped;
    const Ring original = ring.points;
    for (std::size_t i = 0; i < original.size(); ++i) {
      const Point p = original[i];
      const auto move = boundaries.MoveOf(ring.source, p, tolerance);
      snapped.push_back(move ? move->to : p);
      if (move && move->to != p) moves.push_back(*move);
      for (const VertexMove& bend : boundaries.BendsOf(ring.source, p, original[(i + 1) % original.size()], tolerance)) {
        snapped.push_back(bend.to);
        moves.push_back(bend);
      }
    }
    ring.points = std::move(snapped);
  }
  return moves;
}

}  // namespace tautline
