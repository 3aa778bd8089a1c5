#include "tautline/geometry/overlay.h"

#include <algorithm>
#include <array>
#include <map>

#include "tautline/base/check.h"
#include "tautline/geometry/disjoint_sets.h"
#include "tautline/geometry/snap_rounding.h"
#include "tautline/geometry/triangulation.h"

namespace tautline {
namespace {

/// What winds by itself: the domain, the wall's cover, and the cover of each source.
using Layer = std::size_t;
constexpr Layer kDomainLayer = 0;

// Wide enough for sums of products of two coordinate differences on the grid.
__extension__ using Wide = __int128;

Layer CoverLayer(std::int32_t source) { return static_cast<Layer>(source - CoverRing::kWall) + 1; }

/// How often rings of a layer pass an edge from its lower to its higher vertex, minus the other way.
struct Passage {
  std::uint64_t edge;
  Layer layer;
  int count;
};

/// The winding numbers of all layers in one place of the plane.
class Windings {
 public:
  explicit Windings(std::size_t layers) : numbers_(layers, 0) {}

  void Add(Layer layer, int count) {
    const int before = numbers_[layer];
    numbers_[layer] += count;
    if (layer != kDomainLayer) covering_ += (numbers_[layer] > 0 ? 1 : 0) - (before > 0 ? 1 : 0);
  }
  bool Blocked() const { return numbers_[kDomainLayer] == 0 || covering_ > 0; }

 private:
  std::vector<int> numbers_;
  int covering_ = 0;  ///< Layers that cover the place.
};

/// Carries the segments of all rings through snap rounding into a triangulation and reads off what is free.
class OverlayBuilder {
 public:
  OverlayBuilder(const Ring& domain, std::span<const CoverRing> cover, std::int32_t sources);

  Overlay Build();

 private:
  void AddRing(const Ring& ring, Layer layer);
  void TriangulateChains();
  void CollectPassages();
  void FloodWindings();
  void Cross(TriangleId triangle, int side, Windings& windings) const;
  void FindComponents();
  void FindSources();
  void FindInsides();
  void TraceRings();
  OverlayRing TraceRing(TriangleId triangle, int index);

  bool Blocked(TriangleId id) const { return blocked_[id.index()]; }
  bool IsBoundary(TriangleId id, int index) const {
    const TriangleId across = mesh_.triangle(id).neighbour(index);
    return !across.valid() || Blocked(across);
  }
  static std::uint64_t Key(VertexId low, VertexId high) {
    return static_cast<std::uint64_t>(low.value()) << 32 | static_cast<std::uint64_t>(high.value());
  }
  double AreaOf(const Ring& ring) const;

  SnapGrid grid_;
  std::vector<GridSegment> segments_;
  std::vector<Layer> layer_of_segment_;
  Triangulation mesh_;
  std::vector<InputEdge> edges_;  ///< Of the triangulation, from the chains.
  std::vector<std::size_t> segment_of_edge_;
  std::vector<Passage> passages_;                ///< Sorted by edge.
  std::vector<bool> blocked_;                    ///< By triangle.
  std::vector<std::int32_t> free_component_;     ///< By triangle; -1 when blocked.
  std::vector<std::int32_t> blocked_component_;  ///< By vertex; -1 when no blocked triangle touches it.
  std::vector<std::array<bool, 3>> traced_;
  Overlay overlay_;
};

Box BoxOf(const Ring& domain, std::span<const CoverRing> cover) {
  Box box = BoundingBox(domain);
  for (const CoverRing& ring : cover) {
    for (const Point p : ring.points) box.Add(p);
  }
  return box;
}

OverlayBuilder::OverlayBuilder(const Ring& domain, std::span<const CoverRing> cover, std::int32_t sources)
    : grid_(BoxOf(domain, cover)) {
  overlay_.grid = grid_.spacing();
  overlay_.blocked_of_source.assign(static_cast<std::size_t>(sources), -1);
  AddRing(domain, kDomainLayer);
  for (const CoverRing& ring : cover) AddRing(ring.points, CoverLayer(ring.source));
}

void OverlayBuilder::AddRing(const Ring& ring, Layer layer) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GridSegment segment{grid_.Round(ring[i]), grid_.Round(ring[(i + 1) % ring.size()])};
    if (segment.from == segment.to) continue;
    segments_.push_back(segment);
    layer_of_segment_.push_back(layer);
  }
}

void OverlayBuilder::TriangulateChains() {
  const auto chains = SnapRound(segments_);
  std::vector<SnapGrid::Node> nodes;
  for (const auto& chain : chains) nodes.insert(nodes.end(), chain.begin(), chain.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  const auto position = [&nodes](SnapGrid::Node node) {
    return static_cast<std::int32_t>(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin());
  };
  for (std::size_t s = 0; s < chains.size(); ++s) {
    for (std::size_t i = 1; i < chains[s].size(); ++i) {
      edges_.emplace_back(position(chains[s][i - 1]), position(chains[s][i]));
      segment_of_edge_.push_back(s);
    }
  }
  std::vector<Point> points;
  points.reserve(nodes.size());
  for (const SnapGrid::Node node : nodes) points.push_back(grid_.ToPoint(node));
  mesh_ = Triangulation::Build(points, edges_);
}

void OverlayBuilder::CollectPassages() {
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const auto chain = mesh_.ChainOf(e);
    const Layer layer = layer_of_segment_[segment_of_edge_[e]];
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const auto [low, high] = std::minmax(chain[i - 1], chain[i]);
      passages_.push_back({Key(low, high), layer, chain[i - 1] == low ? 1 : -1});
    }
  }
  std::sort(passages_.begin(), passages_.end(), [](const Passage& a, const Passage& b) { return a.edge < b.edge; });
}

/// Updates the windings of a triangle to those of its neighbour across the given side.
void OverlayBuilder::Cross(TriangleId triangle, int side, Windings& windings) const {
  const Triangle& here = mesh_.triangle(triangle);
  if (!here.is_constrained(side)) return;
  // The triangle lies on the left of its edges; each passage along the edge winds the left side once more.
  const VertexId from = here.vertex(Next(side));
  const VertexId to = here.vertex(Previous(side));
  const std::uint64_t edge = Key(std::min(from, to), std::max(from, to));
  auto passage = std::lower_bound(passages_.begin(), passages_.end(), edge,
                                  [](const Passage& p, std::uint64_t key) { return p.edge < key; });
  for (; passage != passages_.end() && passage->edge == edge; ++passage) {
    windings.Add(passage->layer, from < to ? -passage->count : passage->count);
  }
}

/// Walks over all triangles, depth first from the frame, where everything winds zero times, and carries the winding
/// numbers along: forth across an edge, and back across it when all beyond is done.
void OverlayBuilder::FloodWindings() {
  struct Step {
    TriangleId at;
    int next_side;
  };
  const std::size_t count = mesh_.triangles().size();
  Windings windings(CoverLayer(static_cast<std::int32_t>(overlay_.blocked_of_source.size())));
  std::vector<bool> seen(count, false);
  blocked_.assign(count, true);
  std::vector<Step> trail{{mesh_.TriangleAt(VertexId(mesh_.points().size() - 1)), 0}};
  seen[trail[0].at.index()] = true;
  while (!trail.empty()) {
    const auto [at, side] = trail.back();
    if (side == 3) {
      trail.pop_back();
      if (!trail.empty()) Cross(at, mesh_.triangle(at).IndexOf(trail.back().at), windings);
      continue;
    }
    ++trail.back().next_side;
    const TriangleId across = mesh_.triangle(at).neighbour(side);
    if (!across.valid() || seen[across.index()]) continue;
    Cross(at, side, windings);
    seen[across.index()] = true;
    blocked_[across.index()] = windings.Blocked();
    trail.push_back({across, 0});
  }
}

/// Free triangles connect through edges, blocked ones through vertices as well.
void OverlayBuilder::FindComponents() {
  const std::size_t count = mesh_.triangles().size();
  DisjointSets free_sets(count), blocked_sets(mesh_.points().size());
  for (std::size_t t = 0; t < count; ++t) {
    const Triangle& here = mesh_.triangles()[t];
    if (blocked_[t]) {
      blocked_sets.Unite(here.vertices[0].index(), here.vertices[1].index());
      blocked_sets.Unite(here.vertices[0].index(), here.vertices[2].index());
      continue;
    }
    for (const TriangleId across : here.neighbours) {
      if (across.valid() && !Blocked(across)) free_sets.Unite(t, across.index());
    }
  }
  free_component_.assign(count, -1);
  blocked_component_.assign(mesh_.points().size(), -1);
  for (std::size_t t = 0; t < count; ++t) {
    if (!blocked_[t]) {
      const std::size_t root = free_sets.Find(t);
      free_component_[t] = root == t ? overlay_.free_count++ : free_component_[root];
    }
  }
  std::map<std::size_t, std::int32_t> numbers;
  for (std::size_t t = 0; t < count; ++t) {
    if (!blocked_[t]) continue;
    for (const VertexId vertex : mesh_.triangles()[t].vertices) {
      const auto [entry, is_new] = numbers.try_emplace(blocked_sets.Find(vertex.index()), overlay_.blocked_count);
      if (is_new) ++overlay_.blocked_count;
      blocked_component_[vertex.index()] = entry->second;
    }
  }
  overlay_.wall = blocked_component_.back();
}

/// Every edge of a source lies in the closure of a blocked component that the source became part of. A source may be
/// part of several: where it has no width, its ground is parted.
void OverlayBuilder::FindSources() {
  overlay_.source_of_blocked.assign(static_cast<std::size_t>(overlay_.blocked_count), -1);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const Layer layer = layer_of_segment_[segment_of_edge_[e]];
    if (layer < CoverLayer(0)) continue;
    const auto source = static_cast<std::int32_t>(layer - CoverLayer(0));
    for (const VertexId vertex : mesh_.ChainOf(e)) {
      const std::int32_t component = blocked_component_[vertex.index()];
      if (component < 0) continue;
      std::int32_t& first = overlay_.blocked_of_source[static_cast<std::size_t>(source)];
      if (first < 0) first = component;
      std::int32_t& lowest = overlay_.source_of_blocked[static_cast<std::size_t>(component)];
      if (lowest < 0 || source < lowest) lowest = source;
    }
  }
}

/// The centre of the blocked triangle that has the largest area, by component; the wall's is of no use.
void OverlayBuilder::FindInsides() {
  std::vector<double> largest(static_cast<std::size_t>(overlay_.blocked_count), -1);
  overlay_.inside_of_blocked.resize(largest.size());
  for (std::size_t t = 0; t < mesh_.triangles().size(); ++t) {
    if (!blocked_[t]) continue;
    const Triangle& here = mesh_.triangles()[t];
    const Point a = mesh_.point(here.vertices[0]), b = mesh_.point(here.vertices[1]), c = mesh_.point(here.vertices[2]);
    const auto component = static_cast<std::size_t>(blocked_component_[here.vertices[0].index()]);
    const double area = tautline::Cross(b - a, c - a);
    if (area <= largest[component]) continue;
    largest[component] = area;
    overlay_.inside_of_blocked[component] = a + 1.0 / 3 * ((b - a) + (c - a));
  }
}

/// Follows a boundary with free ground on the left, turning within the free sector at each vertex, from the edge
/// opposite to vertices[index] of a free triangle.
OverlayRing OverlayBuilder::TraceRing(TriangleId triangle, int index) {
  OverlayRing ring;
  ring.free = free_component_[triangle.index()];
  TriangleId at = triangle;
  int i = index;
  do {
    traced_[at.index()][static_cast<std::size_t>(i)] = true;
    const VertexId from = mesh_.triangle(at).vertex(Next(i));
    ring.points.push_back(mesh_.point(from));
    ring.blocked = blocked_component_[from.index()];
    // The edge runs to vertex Previous(i); the next edge starts there.
    const VertexId pivot = mesh_.triangle(at).vertex(Previous(i));
    i = Next(i);
    while (!IsBoundary(at, i)) {
      at = mesh_.triangle(at).neighbour(i);
      i = Previous(mesh_.triangle(at).IndexOf(pivot));
    }
  } while (at != triangle || i != index);
  ring.points = DropCollinear(ring.points);
  ring.area = AreaOf(ring.points);
  return ring;
}

/// The signed area, exact until its last conversion: thin rings would lose their sign in doubles.
double OverlayBuilder::AreaOf(const Ring& ring) const {
  Wide twice = 0;
  const SnapGrid::Node first = grid_.Round(ring[0]);
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const SnapGrid::Node a = grid_.Round(ring[i]), b = grid_.Round(ring[i + 1]);
    twice += static_cast<Wide>(a.x - first.x) * (b.y - first.y);
    twice -= static_cast<Wide>(a.y - first.y) * (b.x - first.x);
  }
  return 0.5 * static_cast<double>(twice) * grid_.spacing() * grid_.spacing();
}

void OverlayBuilder::TraceRings() {
  traced_.assign(mesh_.triangles().size(), {});
  for (std::size_t t = 0; t < mesh_.triangles().size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (blocked_[t] || traced_[t][static_cast<std::size_t>(i)] || !IsBoundary(TriangleId(t), i)) continue;
      overlay_.rings.push_back(TraceRing(TriangleId(t), i));
    }
  }
}

Overlay OverlayBuilder::Build() {
  TriangulateChains();
  CollectPassages();
  FloodWindings();
  FindComponents();
  FindSources();
  FindInsides();
  TraceRings();
  return std::move(overlay_);
}

}  // namespace

Overlay ComputeOverlay(const Ring& domain, std::span<const CoverRing> cover, std::int32_t sources) {
  return OverlayBuilder(domain, cover, sources).Build();
}

}  // namespace tautline
