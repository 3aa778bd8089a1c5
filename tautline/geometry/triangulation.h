// Constrained Delaunay triangulation of a planar straight-line graph inside a frame.
#ifndef TAUTLINE_GEOMETRY_TRIANGULATION_H_
#define TAUTLINE_GEOMETRY_TRIANGULATION_H_

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "tautline/base/index.h"
#include "tautline/geometry/point.h"

namespace tautline {

using VertexId = Index<struct VertexTag>;      ///< A vertex of a triangulation.
using TriangleId = Index<struct TriangleTag>;  ///< A triangle of a triangulation.

/// Vertices run counter-clockwise; `neighbours[i]` lies across the edge opposite to `vertices[i]`, that is, from
/// vertices[i+1] to vertices[i+2]; it is invalid on the frame only.
struct Triangle {
  /// Counter-clockwise.
  std::array<VertexId, 3> vertices;
  /// neighbours[i] lies across the edge opposite to vertices[i].
  std::array<TriangleId, 3> neighbours;
  std::array<bool, 3> constrained{};  ///< The edge opposite to vertices[i] is (part of) an input edge.

  /// Vertex i, 0 <= i < 3.
  VertexId vertex(int i) const { return vertices[static_cast<std::size_t>(i)]; }
  /// The triangle across the edge opposite to vertex i; invalid on the frame.
  TriangleId neighbour(int i) const { return neighbours[static_cast<std::size_t>(i)]; }
  /// Whether the edge opposite to vertex i is part of an input edge.
  bool is_constrained(int i) const { return constrained[static_cast<std::size_t>(i)]; }

  /// Which of the three vertices `vertex` is. Requires that it is one.
  int IndexOf(VertexId vertex) const { return vertices[0] == vertex ? 0 : vertices[1] == vertex ? 1 : 2; }
  /// Which of the three neighbours `triangle` is. Requires that it is one.
  int IndexOf(TriangleId triangle) const { return neighbours[0] == triangle ? 0 : neighbours[1] == triangle ? 1 : 2; }
};

/// The position after i of three, counter-clockwise.
constexpr int Next(int i) { return i == 2 ? 0 : i + 1; }
/// The position before i of three.
constexpr int Previous(int i) { return i == 0 ? 2 : i - 1; }

/// An input edge between two input points, by position.
using InputEdge = std::pair<std::int32_t, std::int32_t>;

/// The constrained Delaunay triangulation of points and edges. The domain is a rectangle well outside of the points
/// whose four corners are the last four vertices, so every input point has a full fan of triangles around it.
class Triangulation {
 public:
  /// Of nothing; Build makes one of something.
  Triangulation() = default;

  /// Requires: all points finite and distinct; input edges do not cross each other properly (they may pass through
  /// points and overlap; they are split there). The circumcircle of each triangle contains no vertex that is visible
  /// across unconstrained edges. O(n log n) expected. [Sloan1993 for the constraints]
  static Triangulation Build(std::span<const Point> points, std::span<const InputEdge> edges);

  /// All vertices by VertexId: the input points, then the four corners of the frame.
  std::span<const Point> points() const { return points_; }
  /// All triangles, by TriangleId.
  std::span<const Triangle> triangles() const { return triangles_; }
  /// Where a vertex is.
  Point point(VertexId id) const { return points_[id.index()]; }
  /// A triangle.
  const Triangle& triangle(TriangleId id) const { return triangles_[id.index()]; }
  /// Where vertex i of a triangle is.
  Point corner(TriangleId id, int i) const { return point(triangle(id).vertex(i)); }

  /// A triangle with this vertex.
  TriangleId TriangleAt(VertexId id) const { return triangle_at_[id.index()]; }

  /// The vertices along input edge `edge` in its direction: two, and more where it passes through points.
  std::span<const VertexId> ChainOf(std::size_t edge) const;

  /// A triangle whose closed region contains p. Requires p inside the frame. Exact. O(1) expected.
  TriangleId Locate(Point p) const;

  /// Whether p lies strictly inside of the frame.
  bool InFrame(Point p) const {
    return frame_low_.x < p.x && p.x < frame_high_.x && frame_low_.y < p.y && p.y < frame_high_.y;
  }

 private:
  friend class TriangulationBuilder;

  TriangleId WalkTo(Point p, TriangleId from) const;
  void BuildLocator();

  std::vector<Point> points_;
  std::vector<Triangle> triangles_;
  std::vector<TriangleId> triangle_at_;
  std::vector<VertexId> chain_vertices_;
  std::vector<std::size_t> chain_begin_;
  Point frame_low_, frame_high_;
  // The locator: a grid of triangles to start walking from.
  std::vector<TriangleId> start_;
  int columns_ = 0, rows_ = 0;
  Point inner_low_;
  double cell_ = 1;
};

}  // namespace tautline

#endif  // TAUTLINE_GEOMETRY_TRIANGULATION_H_
