#include "tautline/planners/contact_free/homotopic_voronoi.h"

#include <algorithm>
#include <boost/polygon/segment_data.hpp>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/geometry/snap_rounding.h"
#include "tautline/planners/contact_free/path_lattice.h"
#include "tautline/planners/contact_free/shortest_in_class.h"

namespace tautline {
namespace {

namespace bp = boost::polygon;
using BoostPoint = bp::point_data<std::int32_t>;
using BoostSegment = bp::segment_data<std::int32_t>;
using Diagram = bp::voronoi_diagram<double>;

/// How much longer than the taut path one in the middle of everything may be.
constexpr double kStretch = 2;
constexpr double kSlackDiagonals = 1;

/// The boundaries as segments between points of an integer grid, as Boost.Polygon wants them.
class IntegerSegments {
 public:
  explicit IntegerSegments(const FreeSpace& space) : centre_(space.box.centre()) {
    const Point size = space.box.size();
    scale_ = std::exp2(kBits) / std::exp2(std::ceil(std::log2(std::max(size.x, size.y))));
    std::vector<GridSegment> segments;
    for (const FreeComponent& component : space.components) {
      Append(component.outer.points, segments);
      for (const BoundaryRing& hole : component.holes) Append(hole.points, segments);
    }
    for (const auto& chain : SnapRound(segments)) {
      for (std::size_t i = 0; i + 1 < chain.size(); ++i) Add(chain[i], chain[i + 1]);
    }
    // Rings that touch along a line share edges, and an edge given twice is no input for a diagram.
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    for (const auto& [a, b] : edges_) segments_.emplace_back(ToBoost(a), ToBoost(b));
  }

  const std::vector<BoostSegment>& segments() const { return segments_; }
  Point ToPoint(double x, double y) const { return centre_ + (1 / scale_) * Point{x, y}; }
  double to_metres() const { return 1 / scale_; }

 private:
  using Node = SnapGrid::Node;

  /// The longer side of the world is up to 2^30 of the grid.
  static constexpr double kBits = 30;

  static BoostPoint ToBoost(Node node) {
    return {static_cast<std::int32_t>(node.x), static_cast<std::int32_t>(node.y)};
  }

  Node Round(Point p) const {
    const Point scaled = scale_ * (p - centre_);
    return {std::llround(scaled.x), std::llround(scaled.y)};
  }

  void Append(const Ring& ring, std::vector<GridSegment>& segments) const {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Node from = Round(ring[i]), to = Round(ring[(i + 1) % ring.size()]);
      if (from != to) segments.push_back({from, to});
    }
  }

  void Add(Node a, Node b) {
    if (a != b) edges_.emplace_back(std::min(a, b), std::max(a, b));
  }

  Point centre_;
  double scale_ = 1;
  std::vector<std::pair<Node, Node>> edges_;
  std::vector<BoostSegment> segments_;
};

/// Makes a graph of the edges of a diagram.
class RoadmapBuilder {
 public:
  RoadmapBuilder(const TautSpace& space, const IntegerSegments& input, double sample_m)
      : space_(space), input_(input), sample_(sample_m) {}

  PathGraph Build() {
    Diagram diagram;
    bp::construct_voronoi(input_.segments().begin(), input_.segments().end(), &diagram);
    for (const auto& edge : diagram.edges()) {
      // Each edge is there once for either side.
      if (!edge.is_primary() || !edge.is_finite() || edge.cell() > edge.twin()->cell()) continue;
      AddChain(PointsAlong(edge));
    }
    return {std::move(points_), std::move(edges_)};
  }

 private:
  using Edge = Diagram::edge_type;

  static Point Of(const Diagram::vertex_type& vertex) { return {vertex.x(), vertex.y()}; }
  static Point Of(const BoostPoint& p) { return {static_cast<double>(p.x()), static_cast<double>(p.y())}; }

  const BoostSegment& SegmentOf(const Diagram::cell_type& cell) const { return input_.segments()[cell.source_index()]; }

  Point FocusOf(const Diagram::cell_type& cell) const {
    const bool low = cell.source_category() == bp::SOURCE_CATEGORY_SEGMENT_START_POINT;
    return Of(low ? SegmentOf(cell).low() : SegmentOf(cell).high());
  }

  /// The points of an edge in the units of the grid.
  std::vector<Point> PointsAlong(const Edge& edge) const {
    const Point from = Of(*edge.vertex0()), to = Of(*edge.vertex1());
    const double pieces = std::max(1.0, std::ceil(Distance(from, to) * input_.to_metres() / sample_));
    if (edge.is_linear()) return Straight(from, to, pieces);
    const bool here = edge.cell()->contains_point();
    const Diagram::cell_type& point_cell = here ? *edge.cell() : *edge.twin()->cell();
    const BoostSegment& line = SegmentOf(here ? *edge.twin()->cell() : *edge.cell());
    return Parabola(Straight(from, to, pieces), FocusOf(point_cell), {Of(line.low()), Of(line.high())});
  }

  static std::vector<Point> Straight(Point from, Point to, double pieces) {
    std::vector<Point> points{from};
    for (double i = 1; i < pieces; ++i) points.push_back(Lerp(from, to, i / pieces));
    points.push_back(to);
    return points;
  }

  /// The points of a chord moved onto the parabola between a focus and a line: with x along the line from the foot of
  /// the focus, at height f, it is y = (x² + f²) / 2f. The ends are on it.
  static std::vector<Point> Parabola(std::vector<Point> chord, Point focus, std::pair<Point, Point> line) {
    const Point along = (1 / Distance(line.first, line.second)) * (line.second - line.first);
    Point up{-along.y, along.x};
    double f = Dot(focus - line.first, up);
    if (f < 0) {
      f = -f;
      up = -1 * up;
    }
    const Point foot = focus - f * up;
    for (std::size_t i = 1; i + 1 < chord.size() && f > 0; ++i) {
      const double x = Dot(chord[i] - foot, along);
      chord[i] = foot + x * along + (x * x + f * f) / (2 * f) * up;
    }
    return chord;
  }

  /// The node at a place of the diagram; invalid where the robot may not be. Vertices of the diagram are shared.
  PathNodeId NodeAt(Point on_grid) {
    const auto [entry, added] = nodes_.emplace(on_grid, PathNodeId());
    if (!added) return entry->second;
    if (const auto place = space_.mesh().Locate(input_.ToPoint(on_grid.x, on_grid.y), 0)) {
      entry->second = PathNodeId(points_.size());
      points_.push_back(place->point);
      places_.push_back(*place);
    }
    return entry->second;
  }

  void AddChain(const std::vector<Point>& chain) {
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const PathNodeId a = NodeAt(chain[i]), b = NodeAt(chain[i + 1]);
      if (!a.valid() || !b.valid() || points_[a.index()] == points_[b.index()]) continue;
      if (IsFreeSegment(space_, places_[a.index()], points_[b.index()])) edges_.emplace_back(a, b);
    }
  }

  const TautSpace& space_;
  const IntegerSegments& input_;
  double sample_;
  std::map<Point, PathNodeId> nodes_;
  std::vector<Point> points_;
  std::vector<Place> places_;
  std::vector<PathGraph::Edge> edges_;
};

PathGraph BuildRoadmap(const TautGround& ground, double sample_m) {
  TAUTLINE_CHECK(sample_m > 0);
  const IntegerSegments input(ground.ungrown_space());
  return RoadmapBuilder(ground.space(), input, sample_m).Build();
}

}  // namespace

VoronoiRoadmap::VoronoiRoadmap(const TautGround& ground, double sample_m)
    : ground_(&ground), graph_(BuildRoadmap(ground, sample_m)), piece_(graph_.size(), -1) {
  for (std::size_t i = 0; i < graph_.size(); ++i) {
    if (piece_[i] >= 0) continue;
    std::vector<PathNodeId> open{PathNodeId(i)};
    piece_[i] = pieces_;
    while (!open.empty()) {
      const PathNodeId at = open.back();
      open.pop_back();
      for (const PathNodeId next : graph_.Neighbours(at)) {
        if (piece_[next.index()] >= 0) continue;
        piece_[next.index()] = pieces_;
        open.push_back(next);
      }
    }
    ++pieces_;
  }
}

std::vector<PathNodeId> VoronoiRoadmap::NearestInSight(Place place) const {
  std::vector<std::pair<double, PathNodeId>> by_distance;
  for (std::size_t i = 0; i < graph_.size(); ++i) {
    if (!graph_.Neighbours(PathNodeId(i)).empty()) {
      by_distance.emplace_back(Distance(place.point, graph_.point(PathNodeId(i))), PathNodeId(i));
    }
  }
  std::sort(by_distance.begin(), by_distance.end());
  std::vector<char> joined(static_cast<std::size_t>(pieces_), 0);
  std::vector<PathNodeId> nearest;
  for (const auto& [distance, id] : by_distance) {
    char& done = joined[static_cast<std::size_t>(piece_[id.index()])];
    if (done != 0 || !IsFreeSegment(ground_->space(), place, graph_.point(id))) continue;
    done = 1;
    nearest.push_back(id);
  }
  return nearest;
}

std::optional<Polyline> VoronoiRoadmap::PathInClass(const ClassPathQuery& query, std::int64_t max_states) const {
  const TautSpace& space = ground_->space();
  const auto open = LeaveSocket(*ground_, query);
  if (!open) return std::nullopt;
  std::vector<Point> points;
  std::vector<PathGraph::Edge> edges;
  for (std::size_t i = 0; i < graph_.size(); ++i) {
    points.push_back(graph_.point(PathNodeId(i)));
    for (const PathNodeId next : graph_.Neighbours(PathNodeId(i))) edges.emplace_back(PathNodeId(i), next);
  }
  const PathNodeId from(points.size()), to(points.size() + 1);
  for (const Point end : {open->open.from, open->open.to}) {
    const auto place = space.Locate(end);
    TAUTLINE_CHECK(place);
    const PathNodeId node(points.size());
    points.push_back(end);
    for (const PathNodeId id : NearestInSight(*place)) {
      if (graph_.point(id) != end) {
        edges.emplace_back(node, id);
        continue;
      }
      for (const PathNodeId next : graph_.Neighbours(id)) edges.emplace_back(node, next);
    }
  }
  const PathGraph joined(std::move(points), std::move(edges));
  auto path = ShortestInClass(space, joined,
                              {.from = from,
                               .to = to,
                               .word = open->open.word,
                               .stretch = kStretch,
                               .slack_m = kSlackDiagonals * Norm(space.free_space().box.size()),
                               .max_states = max_states});
  if (!path) return std::nullopt;
  return open->FromBase(*std::move(path));
}

std::optional<Polyline> HomotopicVoronoi(const TautGround& ground, const ClassPathQuery& query,
                                         const HomotopicVoronoiOptions& options) {
  return VoronoiRoadmap(ground, options.sample_m).PathInClass(query, options.max_states);
}

}  // namespace tautline
