#include "tautline/homotopy/corners.h"

#include "tautline/geometry/predicates.h"

namespace tautline {

Side Corner::TangentFrom(Point from) const {
  const int to_previous = Orientation(from, point, previous), to_next = Orientation(from, point, next);
  if (to_previous >= 0 && to_next >= 0) return Side::kLeft;
  if (to_previous <= 0 && to_next <= 0) return Side::kRight;
  return Side::kNone;
}

Corners::Corners(const FreeSpace& space, const FreeMesh& mesh) : at_(3 * mesh.triangulation().triangles().size()) {
  // The mesh holds the rings' edges in this order; each edge starts at a ring vertex with its free sector on the left.
  std::size_t edge = 0;
  const auto add_ring = [&](const BoundaryRing& ring) {
    const std::size_t n = ring.points.size();
    for (std::size_t i = 0; i < n; ++i, ++edge) {
      const Point previous = ring.points[(i + n - 1) % n], point = ring.points[i], next = ring.points[(i + 1) % n];
      if (Orientation(previous, point, next) >= 0) continue;
      const auto chain = mesh.triangulation().ChainOf(edge);
      Add(mesh, previous, point, next, chain[0], mesh.LeftOf(chain[0], chain[1]));
    }
  };
  for (const FreeComponent& component : space.components) {
    add_ring(component.outer);
    for (const BoundaryRing& hole : component.holes) add_ring(hole);
  }
}

void Corners::Add(const FreeMesh& mesh, Point previous, Point point, Point next, VertexId vertex, TriangleId first) {
  const CornerId id(corners_.size());
  corners_.push_back({vertex, point, previous, next, first});
  TriangleId at = first;
  for (;;) {
    const int i = mesh.triangle(at).IndexOf(vertex);
    at_[3 * at.index() + static_cast<std::size_t>(i)] = id;
    if (mesh.triangle(at).is_constrained(Next(i))) return;
    at = mesh.triangle(at).neighbour(Next(i));
  }
}

}  // namespace tautline
