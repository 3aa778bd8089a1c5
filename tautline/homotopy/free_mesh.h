// The triangulated free space. It has no vertex in its interior, so the dual of its universal cover is a tree.
#ifndef TAUTLINE_HOMOTOPY_FREE_MESH_H_
#define TAUTLINE_HOMOTOPY_FREE_MESH_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "tautline/geometry/box_index.h"
#include "tautline/geometry/triangulation.h"
#include "tautline/scene/free_space.h"

namespace tautline {

/// A point of the closed free space with a free triangle that holds it.
struct Place {
  Point point;          ///< The point itself, metres.
  TriangleId triangle;  ///< One of the free triangles whose closed region holds it.
};

/// The constrained Delaunay triangulation of a free space; each triangle is free or blocked.
class FreeMesh {
 public:
  /// O(n log n) for n boundary vertices.
  explicit FreeMesh(const FreeSpace& space);

  /// All triangles, the blocked ones too.
  const Triangulation& triangulation() const { return mesh_; }
  /// Where a vertex is.
  Point point(VertexId id) const { return mesh_.point(id); }
  /// A triangle.
  const Triangle& triangle(TriangleId id) const { return mesh_.triangle(id); }

  /// Whether the triangle exists and is part of the free space.
  bool IsFree(TriangleId id) const { return id.valid() && component_[id.index()] >= 0; }

  /// The connected component of a free triangle, a number from 0 on.
  std::int32_t ComponentOf(TriangleId id) const { return component_[id.index()]; }

  /// Where p is in the closed free space. A point up to `tolerance` metres outside is moved onto the boundary.
  /// Nothing when p is farther outside. O(1) expected.
  std::optional<Place> Locate(Point p, double tolerance) const;

  /// The nearest place on the boundary, with the triangle of its edge: a vertex where one is within `tolerance` of p,
  /// else a point of the edge as far as rounding lets it be one. Nothing when p is farther away than that. O(1)
  /// expected.
  std::optional<Place> MoveOntoBoundary(Point p, double tolerance) const;

  /// The place once for each free sector that it belongs to: several at a vertex where blocked ground touches, one
  /// everywhere else.
  std::vector<Place> Sectors(Place place) const;

  /// Whether a path leads from one place to the other.
  bool Connected(Place a, Place b) const;

  /// The boundary vertices within `tolerance` of the segment ab, in order from a to b. O(1) expected for each.
  std::vector<VertexId> VerticesNear(Point a, Point b, double tolerance) const;

  /// Calls visit(from, to) for every boundary edge, or part of one, whose place in the index meets the box; free ground
  /// is on its left. Repeats are possible. O(1) expected for each.
  template <class Visit>
  void ForEachBoundaryNear(const Box& box, Visit visit) const {
    boundary_index_->ForEachNear(box, [&](std::size_t k) {
      const BoundaryEdge& edge = boundary_[k];
      visit(mesh_.corner(edge.triangle, Next(edge.index)), mesh_.corner(edge.triangle, Previous(edge.index)));
    });
  }

  /// The triangle on the left of the edge from one vertex to another. Requires that the mesh has that edge.
  TriangleId LeftOf(VertexId from, VertexId to) const;

  /// Calls visit(triangle, position of the vertex in it) for every free triangle at a vertex.
  template <class Visit>
  void ForEachFreeAround(VertexId vertex, Visit visit) const {
    const TriangleId first = mesh_.TriangleAt(vertex);
    TriangleId at = first;
    do {
      const int i = mesh_.triangle(at).IndexOf(vertex);
      if (IsFree(at)) visit(at, i);
      at = mesh_.triangle(at).neighbour(Next(i));
    } while (at != first);
  }

 private:
  struct BoundaryEdge {
    TriangleId triangle;  ///< The free triangle on its left.
    int index;            ///< The vertex opposite to the edge there.
  };

  void MarkFree(const std::vector<InputEdge>& edges);
  void IndexBoundary();
  std::optional<Place> OnBoundaryOfBlocked(TriangleId id, Point p) const;
  Place MoveOnto(const BoundaryEdge& edge, Point p, double tolerance) const;
  bool InClosedTriangle(TriangleId id, Point p) const;

  Triangulation mesh_;
  std::vector<std::int32_t> component_;
  std::vector<BoundaryEdge> boundary_;
  std::optional<BoxIndex> boundary_index_;
};

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_FREE_MESH_H_
