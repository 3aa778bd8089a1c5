#include "tautline/geometry/snap_vertices.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

#include "tautline/geometry/box_index.h"

namespace tautline {
namespace {

/// An edge by ring and position of its first vertex.
struct EdgePlace {
  std::size_t ring;
  std::size_t vertex;
};

/// The rings as they were, with an index over their edges, and what has become of them. Distances are those between
/// the rings as they were, so that a move never opens a gap that another move was to close.
class Boundaries {
 public:
  Boundaries(const std::vector<SourcedRing>& rings, double tolerance)
      : rings_(rings), tolerance_(tolerance), index_(Segments()), vertices_(Vertices()) {
    for (const SourcedRing& ring : rings) {
      now_.emplace_back();
      for (const Point p : ring.points) now_.back().push_back({p});
    }
  }

  /// Moves and bends one ring onto those of lower sources, which must have had their turn. Appends to `moves`.
  void Snap(std::size_t ring, std::vector<VertexMove>& moves) {
    const std::size_t count = rings_[ring].points.size();
    for (std::size_t v = 0; v < count; ++v) {
      const auto move = MoveOf({ring, v});
      if (!move) continue;
      now_[ring][v][0] = move->to;
      if (move->to != move->from) moves.push_back(*move);
    }
    for (std::size_t v = 0; v < count; ++v) {
      for (const VertexMove& bend : BendsOf({ring, v})) {
        now_[ring][v].push_back(bend.to);
        if (bend.to != bend.from) moves.push_back(bend);
      }
    }
  }

  Ring Now(std::size_t ring) const {
    Ring points;
    for (const Polyline& part : now_[ring]) points.insert(points.end(), part.begin(), part.end());
    return points;
  }

 private:
  /// What a vertex has come close to: the start of the edge, or else the edge.
  struct Encounter {
    EdgePlace place;
    bool at_start;
    double distance;
  };

  std::optional<VertexMove> MoveOf(EdgePlace vertex) {
    const Point p = StartOf(vertex);
    const std::int32_t source = rings_[vertex.ring].source;
    std::optional<Encounter> best;
    const Point margin{tolerance_, tolerance_};
    index_.ForEachNear({p - margin, p + margin}, [&](std::size_t k) {
      if (rings_[places_[k].ring].source >= source) return;
      const auto encounter = Meet(p, places_[k]);
      if (!encounter || (best && best->at_start && !encounter->at_start)) return;
      const bool better_kind = best && encounter->at_start && !best->at_start;
      if (!best || better_kind || encounter->distance < best->distance) best = encounter;
    });
    if (!best) return std::nullopt;
    const EdgePlace onto = best->place;
    const Point to = best->at_start ? now_[onto.ring][onto.vertex][0] : JoinEdge(onto, p);
    return VertexMove{source, rings_[onto.ring].source, p, to};
  }

  std::optional<Encounter> Meet(Point p, EdgePlace place) const {
    const Point a = StartOf(place), b = StartOf(NextOf(place));
    const double to_a = Distance(p, a), to_b = Distance(p, b);
    if (std::min(to_a, to_b) <= tolerance_) {
      return to_a <= to_b ? Encounter{place, true, to_a} : Encounter{NextOf(place), true, to_b};
    }
    const double to_edge = DistanceToSegment(p, a, b);
    if (to_edge > tolerance_) return std::nullopt;
    return Encounter{place, false, to_edge};
  }

  /// The point nearest to p on what the edge has become. It is made a vertex there, so that both boundaries share it
  /// whatever is rounded later.
  Point JoinEdge(EdgePlace place, Point p) {
    Polyline& part = now_[place.ring][place.vertex];
    const Point end = now_[place.ring][NextOf(place).vertex][0];
    Point nearest = part[0];
    std::size_t after = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Point candidate = NearestOnSegment(p, part[i], i + 1 < part.size() ? part[i + 1] : end);
      if (Distance(p, candidate) >= Distance(p, nearest)) continue;
      nearest = candidate;
      after = i;
    }
    const bool is_vertex = nearest == end || std::find(part.begin(), part.end(), nearest) != part.end();
    if (!is_vertex) part.insert(part.begin() + static_cast<std::ptrdiff_t>(after) + 1, nearest);
    return nearest;
  }

  /// The vertices of lower sources that the edge must be bent through, in its direction.
  std::vector<VertexMove> BendsOf(EdgePlace edge) const {
    const Point a = StartOf(edge), b = StartOf(NextOf(edge));
    const std::int32_t source = rings_[edge.ring].source;
    std::vector<VertexMove> bends;
    vertices_.ForEachAlong(a, b, tolerance_, [&](std::size_t k) {
      const auto [ring, vertex] = places_[k];
      const Point v = StartOf(places_[k]);
      if (rings_[ring].source >= source || Distance(v, a) <= tolerance_ || Distance(v, b) <= tolerance_) return;
      const Point foot = NearestOnSegment(v, a, b);
      if (Distance(v, foot) <= tolerance_) bends.push_back({source, rings_[ring].source, foot, now_[ring][vertex][0]});
    });
    std::sort(bends.begin(), bends.end(), [a](const VertexMove& m, const VertexMove& n) {
      return std::tuple(Distance(a, m.from), m.to, m.onto) < std::tuple(Distance(a, n.from), n.to, n.onto);
    });
    const auto same = [](const VertexMove& m, const VertexMove& n) { return m.to == n.to; };
    bends.erase(std::unique(bends.begin(), bends.end(), same), bends.end());
    return bends;
  }

  Point StartOf(EdgePlace place) const { return rings_[place.ring].points[place.vertex]; }
  EdgePlace NextOf(EdgePlace place) const {
    return {place.ring, (place.vertex + 1) % rings_[place.ring].points.size()};
  }

  std::vector<BoxIndex::Segment> Segments() {
    std::vector<BoxIndex::Segment> segments;
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      for (std::size_t v = 0; v < rings_[r].points.size(); ++v) {
        places_.push_back({r, v});
        segments.emplace_back(StartOf(places_.back()), StartOf(NextOf(places_.back())));
      }
    }
    return segments;
  }

  std::vector<BoxIndex::Segment> Vertices() const {
    std::vector<BoxIndex::Segment> vertices;
    for (const EdgePlace place : places_) vertices.emplace_back(StartOf(place), StartOf(place));
    return vertices;
  }

  const std::vector<SourcedRing>& rings_;
  double tolerance_;
  std::vector<EdgePlace> places_;
  BoxIndex index_;
  BoxIndex vertices_;  ///< Long edges close to each other share many cells, their vertices few.
  /// By ring and vertex: where the vertex is now, and the points that the edge from it passes before the next vertex.
  std::vector<std::vector<Polyline>> now_;
};

}  // namespace

std::vector<VertexMove> SnapVertices(std::vector<SourcedRing>& rings, double tolerance) {
  Boundaries boundaries(rings, tolerance);
  std::vector<std::size_t> order(rings.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&rings](std::size_t a, std::size_t b) { return rings[a].source < rings[b].source; });
  std::vector<VertexMove> moves;
  for (const std::size_t ring : order) boundaries.Snap(ring, moves);
  std::vector<Ring> snapped;
  for (std::size_t r = 0; r < rings.size(); ++r) snapped.push_back(boundaries.Now(r));
  for (std::size_t r = 0; r < rings.size(); ++r) rings[r].points = std::move(snapped[r]);
  return moves;
}

}  // namespace tautline
