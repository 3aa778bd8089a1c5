#include "tautline/geometry/overlay.h"

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>

#include "tautline/base/check.h"
#include "tautline/geometry/disjoint_sets.h"
#include "tautline/geometry/snap_rounding.h"
#include "tautline/geometry/triangulation.h"

namespace tautline {
namespace {

/// How often rings pass an edge from its lower to its higher vertex, minus the other way.
struct Weight {
  int domain = 0;
  int cover = 0;
};

/// Carries the segments of all rings through snap rounding into a triangulation and reads off what is free.
class OverlayBuilder {
 public:
  OverlayBuilder(const Ring& domain, std::span<const CoverRing> cover, std::int32_t sources);

  Overlay Build();

 private:
  void AddRing(const Ring& ring, std::int32_t source, bool is_domain);
  void TriangulateChains();
  void AddWeights();
  void FloodWindings();
  void FindComponents();
  void FindSources();
  void TraceRings();
  OverlayRing TraceRing(TriangleId triangle, int index);

  bool Blocked(TriangleId id) const { return blocked_[id.index()]; }
  bool IsBoundary(TriangleId id, int index) const {
    const TriangleId across = mesh_.triangle(id).neighbours[static_cast<std::size_t>(index)];
    return !across.valid() || Blocked(across);
  }
  static std::uint64_t Key(VertexId low, VertexId high) {
    return static_cast<std::uint64_t>(low.value()) << 32 | static_cast<std::uint64_t>(high.value());
  }
  Weight WeightAlong(VertexId from, VertexId to) const;

  SnapGrid grid_;
  std::vector<GridSegment> segments_;
  std::vector<std::int32_t> source_of_segment_;
  std::vector<bool> domain_segment_;
  Triangulation mesh_;
  std::vector<InputEdge> edges_;                 ///< Of the triangulation, from the chains.
  std::vector<std::size_t> segment_of_edge_;
  std::unordered_map<std::uint64_t, Weight> weights_;
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
  AddRing(domain, CoverRing::kWall, true);
  for (const CoverRing& ring : cover) AddRing(ring.points, ring.source, false);
}

void OverlayBuilder::AddRing(const Ring& ring, std::int32_t source, bool is_domain) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GridSegment segment{grid_.Round(ring[i]), grid_.Round(ring[(i + 1) % ring.size()])};
    if (segment.from == segment.to) continue;
    segments_.push_back(segment);
    source_of_segment_.push_back(source);
    domain_segment_.push_back(is_domain);
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

void OverlayBuilder::AddWeights() {
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const auto chain = mesh_.ChainOf(e);
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const bool upward = chain[i - 1] < chain[i];
      Weight& weight = weights_[upward ? Key(chain[i - 1], chain[i]) : Key(chain[i], chain[i - 1])];
      (domain_segment_[segment_of_edge_[e]] ? weight.domain : weight.cover) += upward ? 1 : -1;
    }
  }
}

Weight OverlayBuilder::WeightAlong(VertexId from, VertexId to) const {
  const auto found = weights_.find(from < to ? Key(from, to) : Key(to, from));
  if (found == weights_.end()) return {};
  return from < to ? found->second : Weight{-found->second.domain, -found->second.cover};
}

/// Carries the winding numbers of domain and cover from the frame, where they are zero, across every edge.
void OverlayBuilder::FloodWindings() {
  const std::size_t count = mesh_.triangles().size();
  std::vector<Weight> winding(count);
  std::vector<bool> seen(count, false);
  blocked_.assign(count, true);
  const VertexId frame_corner(mesh_.points().size() - 1);
  std::vector<TriangleId> stack{mesh_.TriangleAt(frame_corner)};
  seen[stack[0].index()] = true;
  while (!stack.empty()) {
    const TriangleId at = stack.back();
    stack.pop_back();
    const Triangle& here = mesh_.triangle(at);
    blocked_[at.index()] = winding[at.index()].domain == 0 || winding[at.index()].cover > 0;
    for (int i = 0; i < 3; ++i) {
      const TriangleId across = here.neighbours[static_cast<std::size_t>(i)];
      if (!across.valid() || seen[across.index()]) continue;
      // This triangle lies on the left of its edges; each passage along the edge winds the left side once more.
      const Weight weight = here.constrained[static_cast<std::size_t>(i)]
                                ? WeightAlong(here.vertices[static_cast<std::size_t>(Next(i))],
                                              here.vertices[static_cast<std::size_t>(Previous(i))])
                                : Weight{};
      winding[across.index()] = {winding[at.index()].domain - weight.domain, winding[at.index()].cover - weight.cover};
      seen[across.index()] = true;
      stack.push_back(across);
    }
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

/// Every edge of a source lies in the closure of the blocked component that the source became part of.
void OverlayBuilder::FindSources() {
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const std::int32_t source = source_of_segment_[segment_of_edge_[e]];
    if (source == CoverRing::kWall) continue;
    std::int32_t& component = overlay_.blocked_of_source[static_cast<std::size_t>(source)];
    if (component < 0) component = blocked_component_[mesh_.ChainOf(e)[0].index()];
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
    const VertexId from = mesh_.triangle(at).vertices[static_cast<std::size_t>(Next(i))];
    ring.points.push_back(mesh_.point(from));
    ring.blocked = blocked_component_[from.index()];
    // The edge runs to vertex Previous(i); the next edge starts there.
    const VertexId pivot = mesh_.triangle(at).vertices[static_cast<std::size_t>(Previous(i))];
    i = Next(i);
    while (!IsBoundary(at, i)) {
      at = mesh_.triangle(at).neighbours[static_cast<std::size_t>(i)];
      i = Previous(mesh_.triangle(at).IndexOf(pivot));
    }
  } while (at != triangle || i != index);
  ring.points = DropCollinear(ring.points);
  return ring;
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
  AddWeights();
  FloodWindings();
  FindComponents();
  FindSources();
  TraceRings();
  return std::move(overlay_);
}

}  // namespace

Overlay ComputeOverlay(const Ring& domain, std::span<const CoverRing> cover, std::int32_t sources) {
  return OverlayBuilder(domain, cover, sources).Build();
}

}  // namespace tautline
