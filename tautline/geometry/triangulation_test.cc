#include "tautline/geometry/triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalTriangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;

struct Graph {
  std::vector<Point> points;
  std::vector<InputEdge> edges;
};

/// Distinct points, on a coarse lattice half of the time (collinear and cocircular points), and edges that do not
/// cross.
Graph RandomGraph(Rng& rng) {
  Graph graph;
  const bool lattice = rng.UniformInt(0, 1) == 1;
  const int count = rng.UniformInt(1, 40);
  std::set<Point> seen;
  for (int i = 0; i < count; ++i) {
    const Point p = lattice ? Point{1.0 * rng.UniformInt(0, 7), 1.0 * rng.UniformInt(0, 7)}
                            : Point{rng.Uniform(0, 10), rng.Uniform(0, 10)};
    if (seen.insert(p).second) graph.points.push_back(p);
  }
  const auto n = static_cast<int>(graph.points.size());
  for (int i = 0; i < 3 * n; ++i) {
    const InputEdge edge{rng.UniformInt(0, n - 1), rng.UniformInt(0, n - 1)};
    const auto at = [&graph](std::int32_t k) { return graph.points[static_cast<std::size_t>(k)]; };
    const bool crosses = std::any_of(graph.edges.begin(), graph.edges.end(), [&](InputEdge other) {
      return CrossProperly(at(edge.first), at(edge.second), at(other.first), at(other.second));
    });
    if (edge.first != edge.second && !crosses) graph.edges.push_back(edge);
  }
  return graph;
}

void ExpectConsistent(const Triangulation& mesh) {
  for (std::size_t t = 0; t < mesh.triangles().size(); ++t) {
    const TriangleId id(t);
    ASSERT_GT(Orientation(mesh.corner(id, 0), mesh.corner(id, 1), mesh.corner(id, 2)), 0);
    for (int i = 0; i < 3; ++i) {
      const TriangleId across = mesh.triangle(id).neighbour(i);
      if (!across.valid()) continue;
      const auto back = static_cast<std::size_t>(mesh.triangle(across).IndexOf(id));
      ASSERT_EQ(mesh.triangle(across).neighbours[back], id);
      ASSERT_EQ(mesh.triangle(across).constrained[back], mesh.triangle(id).is_constrained(i));
      if (mesh.triangle(across).constrained[back]) continue;
      const Point apex = mesh.point(mesh.triangle(across).vertices[back]);
      ASSERT_LE(InCircle(mesh.corner(id, 0), mesh.corner(id, 1), mesh.corner(id, 2), apex), 0);
    }
  }
}

std::set<std::pair<Point, Point>> ConstrainedEdges(const Triangulation& mesh) {
  std::set<std::pair<Point, Point>> edges;
  for (std::size_t t = 0; t < mesh.triangles().size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (!mesh.triangles()[t].is_constrained(i)) continue;
      edges.insert(std::minmax(mesh.corner(TriangleId(t), Next(i)), mesh.corner(TriangleId(t), Previous(i))));
    }
  }
  return edges;
}

std::set<std::pair<Point, Point>> CgalConstrainedEdges(const Graph& graph) {
  CgalTriangulation oracle;
  std::vector<CgalTriangulation::Vertex_handle> handles;
  for (const Point p : graph.points) handles.push_back(oracle.insert({p.x, p.y}));
  for (const auto& [a, b] : graph.edges) {
    oracle.insert_constraint(handles[static_cast<std::size_t>(a)], handles[static_cast<std::size_t>(b)]);
  }
  std::set<std::pair<Point, Point>> edges;
  for (auto edge = oracle.finite_edges_begin(); edge != oracle.finite_edges_end(); ++edge) {
    if (!oracle.is_constrained(*edge)) continue;
    const auto segment = oracle.segment(*edge);
    edges.insert(std::minmax(Point{segment.source().x(), segment.source().y()},
                             Point{segment.target().x(), segment.target().y()}));
  }
  return edges;
}

TEST(Triangulation, AgreesWithCgalOnRandomGraphs) {
  const auto count = static_cast<std::uint64_t>(ScaledTestCount(3000));
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const Graph graph = RandomGraph(rng);
    const Triangulation mesh = Triangulation::Build(graph.points, graph.edges);
    ExpectConsistent(mesh);
    // Euler: a triangulated rectangle with n inner vertices has 2n + 2 triangles.
    ASSERT_EQ(mesh.triangles().size(), 2 * graph.points.size() + 2);
    ASSERT_EQ(ConstrainedEdges(mesh), CgalConstrainedEdges(graph));
    if (HasFatalFailure()) return;
  }
}

TEST(Triangulation, LocatesRandomPoints) {
  Rng rng(7);
  for (int round = 0; round < 200; ++round) {
    const Graph graph = RandomGraph(rng);
    const Triangulation mesh = Triangulation::Build(graph.points, graph.edges);
    for (int i = 0; i < 50; ++i) {
      const Point p =
          i % 2 == 0
              ? Point{rng.Uniform(-5, 15), rng.Uniform(-5, 15)}
              : graph.points[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(graph.points.size()) - 1))];
      if (!mesh.InFrame(p)) continue;
      const TriangleId id = mesh.Locate(p);
      for (int k = 0; k < 3; ++k) EXPECT_GE(Orientation(mesh.corner(id, k), mesh.corner(id, Next(k)), p), 0);
    }
  }
}

TEST(Triangulation, SplitsAnEdgeThatPassesThroughPoints) {
  const std::vector<Point> points{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1.5, 1}, {1.5, -1}};
  const std::vector<InputEdge> edges{{0, 3}};
  const Triangulation mesh = Triangulation::Build(points, edges);
  const std::vector<VertexId> expected{VertexId(0), VertexId(1), VertexId(2), VertexId(3)};
  const auto chain = mesh.ChainOf(0);
  EXPECT_TRUE(std::equal(chain.begin(), chain.end(), expected.begin(), expected.end()));
}

TEST(Triangulation, ACircleInABoxTakesTimeInProportion) {
  // Each corner of the frame sees a quarter of the circle, across an edge of the box: a walk around its fan for every
  // edge to flip would take minutes.
  constexpr int kPoints = 400000;
  std::vector<Point> points{{-101, -101}, {101, -101}, {101, 101}, {-101, 101}};
  std::vector<InputEdge> edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2 * std::numbers::pi * i / kPoints;
    points.push_back(100 * Point{std::cos(angle), std::sin(angle)});
    edges.emplace_back(4 + i, 4 + (i + 1) % kPoints);
  }
  const Triangulation mesh = Triangulation::Build(points, edges);
  ExpectConsistent(mesh);
  EXPECT_EQ(ConstrainedEdges(mesh).size(), edges.size());
}

TEST(Triangulation, RefusesProperlyCrossingEdges) {
  const std::vector<Point> points{{0, 0}, {2, 2}, {0, 2}, {2, 0}};
  const std::vector<InputEdge> edges{{0, 1}, {2, 3}};
  EXPECT_THROW(Triangulation::Build(points, edges), std::logic_error);
}

}  // namespace
}  // namespace tautline
