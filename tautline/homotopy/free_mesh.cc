#include "tautline/homotopy/free_mesh.h"

#include <algorithm>
#include <map>

#include "tautline/base/check.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// The distinct boundary points of a free space and its directed edges between them, free ground on the left.
struct BoundaryGraph {
  std::vector<Point> points;
  std::vector<InputEdge> edges;

  void Add(const BoundaryRing& ring) {
    const auto position = [this](Point p) {
      return static_cast<std::int32_t>(std::lower_bound(points.begin(), points.end(), p) - points.begin());
    };
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
      edges.emplace_back(position(ring.points[i]), position(ring.points[(i + 1) % ring.points.size()]));
    }
  }
};

BoundaryGraph GraphOf(const FreeSpace& space) {
  BoundaryGraph graph;
  const auto for_each_ring = [&space](auto visit) {
    for (const FreeComponent& component : space.components) {
      visit(component.outer);
      for (const BoundaryRing& hole : component.holes) visit(hole);
    }
  };
  for_each_ring([&graph](const BoundaryRing& ring) {
    graph.points.insert(graph.points.end(), ring.points.begin(), ring.points.end());
  });
  std::sort(graph.points.begin(), graph.points.end());
  graph.points.erase(std::unique(graph.points.begin(), graph.points.end()), graph.points.end());
  for_each_ring([&graph](const BoundaryRing& ring) { graph.Add(ring); });
  return graph;
}

}  // namespace

FreeMesh::FreeMesh(const FreeSpace& space) {
  const BoundaryGraph graph = GraphOf(space);
  mesh_ = Triangulation::Build(graph.points, graph.edges);
  MarkFree(graph.edges);
  IndexBoundary();
}

void FreeMesh::MarkFree(const std::vector<InputEdge>& edges) {
  component_.assign(mesh_.triangles().size(), -1);
  std::int32_t components = 0;
  std::vector<TriangleId> stack;
  const auto add = [&](TriangleId id) {
    if (component_[id.index()] >= 0) return;
    component_[id.index()] = components;
    stack.push_back(id);
  };
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const TriangleId left = LeftOf(mesh_.ChainOf(e)[0], mesh_.ChainOf(e)[1]);
    if (IsFree(left)) continue;
    add(left);
    while (!stack.empty()) {
      const Triangle& here = mesh_.triangle(stack.back());
      stack.pop_back();
      for (int i = 0; i < 3; ++i) {
        if (here.is_constrained(i)) continue;
        // Else the ring has free ground on its right, and all around the world.
        TAUTLINE_CHECK(here.neighbour(i).valid());
        add(here.neighbour(i));
      }
    }
    ++components;
  }
}

TriangleId FreeMesh::LeftOf(VertexId from, VertexId to) const {
  TriangleId at = mesh_.TriangleAt(from);
  for (;;) {
    const int i = mesh_.triangle(at).IndexOf(from);
    if (mesh_.triangle(at).vertex(Next(i)) == to) return at;
    at = mesh_.triangle(at).neighbour(Next(i));
  }
}

void FreeMesh::IndexBoundary() {
  std::vector<BoxIndex::Segment> segments;
  for (std::size_t t = 0; t < component_.size(); ++t) {
    const TriangleId id(t);
    if (!IsFree(id)) continue;
    for (int i = 0; i < 3; ++i) {
      if (!mesh_.triangle(id).is_constrained(i)) continue;
      boundary_.push_back({id, i});
      segments.emplace_back(mesh_.corner(id, Next(i)), mesh_.corner(id, Previous(i)));
    }
  }
  boundary_index_.emplace(segments);
}

bool FreeMesh::InClosedTriangle(TriangleId id, Point p) const {
  for (int i = 0; i < 3; ++i) {
    if (Orientation(mesh_.corner(id, i), mesh_.corner(id, Next(i)), p) < 0) return false;
  }
  return true;
}

/// p lies in the closed blocked triangle `id`: perhaps on its boundary to free ground.
std::optional<Place> FreeMesh::OnBoundaryOfBlocked(TriangleId id, Point p) const {
  for (int i = 0; i < 3; ++i) {
    if (mesh_.corner(id, i) == p) {
      std::optional<Place> place;
      ForEachFreeAround(mesh_.triangle(id).vertex(i), [&](TriangleId free, int) { place = Place{p, free}; });
      return place;
    }
    const TriangleId across = mesh_.triangle(id).neighbour(i);
    if (IsFree(across) && Orientation(mesh_.corner(id, Next(i)), mesh_.corner(id, Previous(i)), p) == 0) {
      return Place{p, across};
    }
  }
  return std::nullopt;
}

/// The point of the boundary edge nearest to p, its end when that is about as near, just inside the free triangle.
Place FreeMesh::MoveOnto(const BoundaryEdge& edge, Point p, double tolerance) const {
  const Point a = mesh_.corner(edge.triangle, Next(edge.index)), b = mesh_.corner(edge.triangle, Previous(edge.index));
  for (const Point end : {a, b}) {
    if (Distance(p, end) <= tolerance) return {end, edge.triangle};
  }
  const Point foot = NearestOnSegment(p, a, b), inner = mesh_.corner(edge.triangle, edge.index);
  Point moved = foot;
  // The foot is rounded and may lie outside by some units in the last place.
  for (double share = 0x1.0p-50; !InClosedTriangle(edge.triangle, moved) && share < 1; share *= 4) {
    moved = Lerp(foot, inner, share);
  }
  return {moved, edge.triangle};
}

std::optional<Place> FreeMesh::Locate(Point p, double tolerance) const {
  if (!mesh_.InFrame(p)) return std::nullopt;
  const TriangleId id = mesh_.Locate(p);
  if (IsFree(id)) return Place{p, id};
  if (const auto place = OnBoundaryOfBlocked(id, p)) return place;
  return MoveOntoBoundary(p, tolerance);
}

std::optional<Place> FreeMesh::MoveOntoBoundary(Point p, double tolerance) const {
  std::optional<std::size_t> nearest;
  double least = tolerance;
  boundary_index_->ForEachNear({p - Point{tolerance, tolerance}, p + Point{tolerance, tolerance}}, [&](std::size_t k) {
    const BoundaryEdge& edge = boundary_[k];
    const double distance = DistanceToSegment(p, mesh_.corner(edge.triangle, Next(edge.index)),
                                              mesh_.corner(edge.triangle, Previous(edge.index)));
    if (distance > least || (nearest && distance == least)) return;
    least = distance;
    nearest = k;
  });
  if (!nearest) return std::nullopt;
  return MoveOnto(boundary_[*nearest], p, tolerance);
}

std::vector<Place> FreeMesh::Sectors(Place place) const {
  const Triangle& here = mesh_.triangle(place.triangle);
  const auto vertex = std::find_if(here.vertices.begin(), here.vertices.end(),
                                   [&](VertexId id) { return mesh_.point(id) == place.point; });
  if (vertex == here.vertices.end()) return {place};
  // Each sector starts, counter-clockwise, at a triangle with a wall on its right.
  std::vector<Place> sectors;
  ForEachFreeAround(*vertex, [&](TriangleId id, int i) {
    if (mesh_.triangle(id).is_constrained(Previous(i))) sectors.push_back({place.point, id});
  });
  return sectors;
}

bool FreeMesh::Connected(Place a, Place b) const {
  const std::vector<Place> starts = Sectors(a), ends = Sectors(b);
  return std::any_of(starts.begin(), starts.end(), [&](Place start) {
    return std::any_of(ends.begin(), ends.end(),
                       [&](Place end) { return ComponentOf(start.triangle) == ComponentOf(end.triangle); });
  });
}

std::vector<VertexId> FreeMesh::VerticesNear(Point a, Point b, double tolerance) const {
  std::vector<std::pair<double, VertexId>> found;
  boundary_index_->ForEachAlong(a, b, tolerance, [&](std::size_t k) {
    const BoundaryEdge& edge = boundary_[k];
    const VertexId vertex = mesh_.triangle(edge.triangle).vertex(Next(edge.index));
    const Point v = mesh_.point(vertex);
    if (DistanceToSegment(v, a, b) <= tolerance) found.emplace_back(Dot(v - a, b - a), vertex);
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::vector<VertexId> vertices;
  vertices.reserve(found.size());
  for (const auto& [along, vertex] : found) vertices.push_back(vertex);
  return vertices;
}

}  // namespace tautline
